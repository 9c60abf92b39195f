#pragma once

#include <span>

#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "raster/pair_mark.h"

/// The CPU definition of every pass, in plain loops and double precision: what the graphics processor must compute.
/// Written to be read and to test against, not to be fast. All functions are pure and thread-safe.
namespace inkedge::reference {

/// Equation 5: [1 2 1] and [-1 0 1].
inline constexpr double sobelSmoothing[] = {1.0, 2.0, 1.0};
inline constexpr double sobelDerivative[] = {-1.0, 0.0, 1.0};
/// Equation 8, after Farid and Simoncelli 1997. The paper's text lost the minus signs of d: it is antisymmetric.
inline constexpr double faridSmoothing[] = {0.036470, 0.248968, 0.429123, 0.248968, 0.036470};
inline constexpr double faridDerivative[] = {-0.108385, -0.280349, 0.0, 0.280349, 0.108385};

/// What is seen through each pixel's centre: sections 2.1.1 and 2.1.2.
struct Surface {
    Image<double> depth;        ///< eye-space depth, scene units; background: camera.far
    Image<double> windowDepth;  ///< 0 at near, 1 at far; background: 1
    /// 3 channels: the interpolated normal, unit length, turned to the side that is seen; background: 0.
    Image<double> normal;
};

/// Finds for each pixel the nearest triangle between near and far at the pixel's centre (homogeneous rasterisation).
/// The GPU twin is drawSurface(). The two may differ at pixels whose centre lies within 1/256 pixel of a triangle's
/// edge, since graphics processors snap vertices to such a grid. O(pixels covered by each triangle's bounds).
[[nodiscard]] Surface drawSurface(const Scene&, const Camera&, LightSpace, Size);

/// The light that a white diffuse surface receives from a red, a green and a blue directional light along +X, +Y and +Z
/// and from lights of negative intensity along -X, -Y and -Z. Equals the normal. Section 2.1.2.
[[nodiscard]] glm::dvec3 sixLights(glm::dvec3 unitNormal) noexcept;

/// The depth that edges are found in: 0..1 from near to far.
/// @param depth  eye-space depth, scene units
[[nodiscard]] Image<double> scaledDepth(const Image<double>& depth, const Camera&, DepthMap);

/// Gradient magnitude (equation 6) of one channel of an image, with the kernels I_x = d along x, p along y and I_y the
/// other way round, used as printed. Beyond the border the border pixel is repeated.
/// @return        height x width, row-major, row 0 at the top; the image's unit times the kernel's gain
/// @throws Error  (Kind::Usage) if there is no such channel
[[nodiscard]] Image<double> gradientMagnitude(const Image<double>& image, int channel, Kernel);

/// Appendix A on both maps.
struct Edges {
    Image<double> depthMagnitude;
    Image<double> normalMagnitude;   ///< the largest of the three channels
    Image<std::uint8_t> depthEdges;  ///< 255 where the magnitude >= T, else 0: equation 7
    Image<std::uint8_t> normalEdges;
    Image<std::uint8_t> edges;  ///< depth edges or normal edges
};

/// GPU twins: shaders/detect_edges.frag for the edges, shaders/measure_edges.frag for the magnitudes.
/// @param depth   eye-space depth, scene units
/// @param normal  3 channels
/// @throws Error  (Kind::Usage) if the sizes differ
[[nodiscard]] Edges detectEdges(const Image<double>& depth, const Image<double>& normal, const Camera&,
                                const DetectorSettings&);

/// Lines without thresholds. On a plane w = 1 / z (orthographic: w = -z) is linear in the picture. Let g_p and g_q be
/// the slopes of w over the step from p to q on the planes of p and q. The residuals r_p = w_q - (w_p + g_p) and r_q =
/// w_p - (w_q - g_q) have one sign where the planes meet on the step: the surface goes on. Else it jumps if
///
///     min(|r_p|, |r_q|) k > c (1 + min(|g_p|, |g_q|) k),    k = f / max(w_p, w_q)
///
/// where c is 1 between patches, within a patch 0.02: a mark there only says where to ask the mesh, and f is the focal
/// length in pixels (orthographic: k = f, pixels per unit length). Differences of w times k are then pixel footprints,
/// so that no unit, distance or size of the scene matters. GPU twin: shaders/detect_lines.frag.
/// @param planes       4 channels: w, dw/dx, dw/dy a pixel, the patch's number; 0: background
/// @param focalLength  f along y
/// @param pixelAspect  a pixel's width by its height: f along x is f along y by this
/// @param creaseAngle  degrees
/// @return             one byte per pixel: PairMark bits, the low four for the pixel and the one to its right, the high
///                     four for the pixel and the one below
/// @throws Error       (Kind::Usage) if there are not 4 channels
[[nodiscard]] Image<std::uint8_t> detectLines(const Image<float>& planes, double focalLength, bool orthographic,
                                              double creaseAngle, double pixelAspect = 1.0);

/// The values of a surface function at the centres of pixels: Hertzmann 1999, section 2.1.3. Functions that read
/// pictures or users' shaders have no definition here. The definitions are in src/reference/functions.cpp; GPU twins:
/// shaders/functions.
/// @return        4 channels; background: the row's value, or 1e30 in the last channel where it has none
/// @throws Error  (Kind::Usage) if the function reads a file or its materials have pictures
[[nodiscard]] Image<double> drawFunction(const Scene&, const Camera&, const FunctionSettings&, Size);

/// Equation 6 on the values of a function, the largest of its channels. Differences are taken from the pixel's own
/// value, modulo wrapPeriod(). On a background without a value differences and magnitudes are 0. GPU twins:
/// detect_function.frag, measure_function.frag.
/// @param values  4 channels, as drawFunction() returns them
[[nodiscard]] Image<double> functionMagnitude(const Image<double>& values, const FunctionSettings&);

/// How dark profiles and internal edges are, 0 to 1: the square of the larger of min((g_max - g_min) / k_p, 1), over
/// the 3 x 3 pixels around, and min(|l| / k_l, 1), where
///
///     A B C    g = (|A + 2 B + C - F - 2 G - H| + |C + 2 E + H - A - 2 D - F|) / 8
///     D X E    l = (8 X - A - B - C - D - E - F - G - H) / 3
///     F G H
///
/// are taken of the depths less that of the pixel, in footprints of the pixel and clamped to 1000, the depth of the
/// background. In perspective they are depths of 1 / z, so that planes stay planes. The result is 0 on the background.
/// After Saito and Takahashi 1990, whose text was not at hand: the limits k_p and k_l are settings. GPU twin:
/// detect_profiles.frag.
/// @param depth   eye-space depth, scene units
/// @param normal  3 channels; background: 0
[[nodiscard]] Image<double> detectProfiles(const Image<double>& depth, const Image<double>& normal, const Camera&,
                                           const DetectorSettings&);

/// What lies under the lines, at the centres of pixels. Let b be the base colour (linear light: colour of the material
/// times that of the vertices), B the same in sRGB, n the normal, turned to the side that is seen, and l the direction
/// towards the light:
///
///     BaseColor   B
///     Light       sRGB of b (0.2 + 0.8 max(n . l, 0))
///     Flat        the same with the normal of the face
///     Gooch       the mean of 0.3 (1, 1, 0) + 0.65 B, weighted by 1 + n . l, and 0.4 (0, 0, 1) + 0.35 B, weighted by
///                 1 - n . l, each at most 1: Gooch et al. 1998, brighter, so that lines stand out
///
/// GPU twin: draw_shade.frag.
/// @param towardsLight  view space, unit length
/// @return              4 channels, sRGB, 0 to 1; 0 on the background
/// @throws Error        (Kind::Usage) if the materials have pictures
[[nodiscard]] Image<double> drawShade(const Scene&, const Camera&, Shade, glm::dvec3 towardsLight, Size);

/// Lines by polygons that are added to the model's, hidden by depth alone: Raskar and Cohen 1999, Raskar 2001.
///
/// All triangles are drawn as paper. Ink is drawn
/// - beyond an edge of a back face, beside which the face goes on as a front face (a silhouette), and of any face at a
///   border: as deep as the edge, and 1/4 of a footprint deeper;
/// - along an edge of two faces that meet in a crease and are seen from the same side: on each of the two, in its
///   plane, half as wide, and 1/4 of a footprint nearer; but from edge to edge no depth is used that the face does
///   not have
///
/// where a pixel's centre lies on that side of the edge, or beyond its ends, and within the width of it. Which faces
/// meet, and in a crease, scene::faceEdgesOf() says. With a width of 1 the silhouettes are those of Gooch et al. 1999,
/// of back faces as wires. GPU twin: draw_fattened.geom.
/// @param width  pixels
/// @return       255 where a pixel's centre sees ink, else 0
[[nodiscard]] Image<std::uint8_t> drawFattened(const Scene&, const Camera&, double width, Size);

/// How much hatch marks cover of each sample, 0 to 1: Hertzmann 1999, Figure 2(b).
///
/// Where two facets meet between neighbouring samples (a step or two from the sample, along a row or a column) there is
/// a straight mark, along which the planes of the facets have the same depth. Let a be the angle between the facets, l
/// the light that falls on them from the upper left, and t = bend max(1 - shade + 3 shade l^1.5, 0.1). The tone of the
/// mark is a step from 0 at a = 0.7 t to 1 at 1.3 t, smooth as 3 x^2 - 2 x^3. The mark covers min(1/2 + width/2 - d,
/// width) of a sample that lies d samples away. Facets that meet in one point only, and surfaces of which one lies in
/// front of the other, have no mark. GPU twin: hatch.frag.
/// @param planes       as for detectLines()
/// @param focalLength  as for detectLines()
/// @param bend         degrees
/// @param width        samples
[[nodiscard]] Image<double> hatch(const Image<float>& planes, double focalLength, bool orthographic, double bend,
                                  double shade, double width);

/// How much ink a soft brush leaves, 0 to 1: after Hertzmann 1999, Figure 2(c).
///
/// The channels are the normal, of which a step of 1/2 takes half of the ink, and the depth from near to far, of which
/// a step of 0.06 does. Depth is first rounded down to one of sumiStreaks steps, if there are any. The channels are
/// blurred by a Gaussian of a quarter of the brush's width. Let m be the largest gradient magnitude of the channels
/// (equations 5 and 6), in units in which a step of 1 has magnitude 1: the ink is m^1.5 / (1 + m^1.5).
///
/// The ink is smeared along the edges, sumiLength pixels each way, in steps of a pixel: it is the mean, weighted by a
/// Gaussian of half that length, along lines across the major axis of the structure tensor, which is blurred by a
/// Gaussian of half the width. Where the tensor has no axis ink is not smeared. GPU twins: sumi_channels.frag,
/// blur.frag, sumi_gradients.frag, sumi_tangents.frag, sumi_brush.frag.
/// @param depth   eye-space depth, scene units
/// @param normal  3 channels; background: 0
[[nodiscard]] Image<double> sumi(const Image<double>& depth, const Image<double>& normal, const Camera&,
                                 const StyleSettings&);

/// A drawing in loose strokes, after Curtis 1998 (reference 5 of Hertzmann 1999): the drawing is drawn pencilStrokes
/// times, each time displaced by smooth noise, one over the other. The noise depends on the pixel and the seed only, so
/// that equal lines are displaced equally in all pictures of one seed. GPU twin: pencil.frag.
/// @param drawing  4 channels, 0 to 255, not premultiplied, on a transparent background
/// @return         4 channels, 0 to 1, not premultiplied
[[nodiscard]] Image<double> pencil(const Image<std::uint8_t>& drawing, const StyleSettings&);

/// The outline picture of the classic detector. Fast twin: src/passes/composite.h.
/// @return  1, 3 or 4 channels, as Maps::picture
[[nodiscard]] Image<std::uint8_t> composite(const Image<std::uint8_t>& edges, const PictureSettings&);

}  // namespace inkedge::reference
