#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/export.h>
#include <inkedge/image.h>
#include <inkedge/line_types.h>
#include <inkedge/surface_functions.h>

namespace inkedge {

/// How a mesh comes by its normals.
enum class Normals {
    Auto,      ///< the file's; where it has none, smooth ones split at the crease angle
    Authored,  ///< the file's; where it has none, one per face, as glTF 2.0 prescribes
    Flat,      ///< one per face
};

/// What makes an edge a crease.
enum class Creases {
    Auto,     ///< the bend of its faces, and the file's normals where they deserve belief
    Angle,    ///< the bend of its faces alone
    Normals,  ///< that the file's normals are split; where it has none, the bend of its faces
};

/// What becomes of materials that blend with what lies behind them (glTF's alpha mode BLEND).
enum class Transparent {
    Solid,   ///< drawn like any other
    Ignore,  ///< left out
};

/// What becomes of materials whose pictures have holes (glTF's alpha mode MASK).
enum class AlphaMask {
    Cut,     ///< what is not there is not drawn, and where it begins is an edge
    Ignore,  ///< drawn whole
};

/// Which sides of faces are seen.
enum class BackFaces {
    Draw,      ///< both, whatever the material says
    Material,  ///< both only where the material is double-sided, as glTF 2.0 prescribes
};

/// How much of a machine one file may take. What goes beyond is refused before it is made.
struct LoadLimits {
    std::uint64_t fileSize = 2'147'483'647;          ///< bytes of a model and all files that belong to it
    std::uint64_t decompressedSize = 1'073'741'824;  ///< bytes that compressed geometry comes to
    std::uint64_t vertices = 134'217'728;            ///< vertices and indices of all meshes drawn; below 2^32
    std::uint64_t instances = 16'777'216;            ///< meshes drawn, each time counted
    std::uint64_t nodes = 4'194'304;                 ///< of a model's trees of nodes
    std::uint64_t nodeDepth = 1'048'576;             ///< from a root down, roots are at 1
    std::uint64_t imagePixels = 67'108'864;          ///< of one picture
    double readingTime = 600.0;                      ///< seconds, of CAD files and implicit surfaces, over 0
};

/// What one unit of a model's coordinates is.
enum class LengthUnit { None, Metre, Millimetre, Centimetre, Inch, Foot };

/// Where technical drawings see a model from. Iso shows width, depth and height at one scale, from the right, the front
/// and above; Dimetric shows depth at half the scale of the others (ISO 5456-3).
enum class NamedView { Front, Back, Left, Right, Top, Bottom, Iso, Dimetric };

/// How several views of a model are framed.
enum class Framing {
    Auto,      ///< together if one of them is a NamedView, else each
    Each,      ///< so that the model fills each picture
    Together,  ///< at one scale, at which the largest fits, the middle of the model in the same place
};

/// Where a model is seen from. World space is the file's, right-handed. Scene::up() is up; Scene::front() is where the
/// model's front looks to. What is not given is chosen so that the whole model is framed.
struct CameraSettings {
    std::optional<glm::dvec3> position;
    std::optional<glm::dvec3> focalPoint;
    std::optional<glm::dvec3> viewUp;          ///< upwards in the picture: rolls the camera; none: Scene::up()
    std::optional<glm::dvec3> direction;       ///< from the camera into the scene
    std::optional<NamedView> view;             ///< orthographic unless viewAngle is given
    std::optional<double> azimuthAngle;        ///< degrees about Scene::up(), from the front towards the right
    std::optional<double> elevationAngle;      ///< degrees above the horizon
    std::optional<double> viewAngle;           ///< vertical, degrees; none: 35
    std::optional<double> orthographicHeight;  ///< scene units across the picture's height; 0 frames the model
    std::optional<int> index;                  ///< a camera of the file
    double zoomFactor = 1.0;                   ///< over 1 magnifies
    Framing framing = Framing::Auto;
};

/// An 8-bit sRGB colour.
struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    [[nodiscard]] bool grey() const noexcept { return red == green && green == blue; }
    friend bool operator==(const Color&, const Color&) = default;
};

/// A length in the picture.
struct PictureLength {
    double value = 0.0;
    bool millimetres = false;  ///< the value's unit; else output pixels
    friend bool operator==(const PictureLength&, const PictureLength&) = default;
};

/// A page of paper, millimetres.
struct PageSize {
    double width = 0.0;
    double height = 0.0;
    friend bool operator==(const PageSize&, const PageSize&) = default;
};

/// A dash and the gap after it, both over 0, along the centre of a line. Round caps make a dash longer by its width.
struct DashPattern {
    PictureLength dash;
    PictureLength gap;
    friend bool operator==(const DashPattern&, const DashPattern&) = default;
};

/// The pen of hidden lines of every type. What is not given is as the type's pen has it, at half its width; dashes are
/// six widths long, four apart.
struct HiddenPenSettings {
    std::optional<PictureLength> width;
    std::optional<Color> color;
    std::optional<DashPattern> dash;  ///< of HiddenLines::Dashed
    friend bool operator==(const HiddenPenSettings&, const HiddenPenSettings&) = default;
};

/// The pen of one type of line. What is not given is as PictureSettings::lineColor and ::lineWidth, of which lines of
/// form have 0.6, tangent lines half.
struct PenSettings {
    std::optional<PictureLength> width;
    std::optional<Color> color;
    friend bool operator==(const PenSettings&, const PenSettings&) = default;
};

struct PictureSettings {
    static constexpr int maxSide = 32768;    ///< of size
    static constexpr int minTileSize = 256;  ///< of tileSize
    static constexpr int maxTileSize = 8192;

    Size size{1024, 1024};  ///< pixels, 1 to maxSide along each axis
    Color lineColor{0, 0, 0};
    std::optional<Color> background = Color{255, 255, 255};  ///< none: transparent
    PictureLength lineWidth{1.5, false};                     ///< 0.5 to 32 pixels
    /// Pixels per inch, for what is measured in millimetres; none: 96, and files of pixels do not tell.
    std::optional<double> dpi;
    std::optional<PageSize> page;  ///< the page that vectors are for; none: the size at dpi
    int supersampling = 1;         ///< samples per pixel along each axis: 1, 2 or 4
    int tileSize = 4096;           ///< the largest side of what is drawn at once, samples: trades memory for time
    LineTypes lines = standardLineTypes;          ///< which types are drawn
    std::array<PenSettings, lineTypeCount> pens;  ///< one per line type, in the order of LineType's bits
    HiddenPenSettings hiddenPen;

    [[nodiscard]] double pixelsPerInch() const noexcept { return dpi.value_or(96.0); }
};

/// The size of a picture as it is asked for, in pixels or, at PictureSettings::dpi, millimetres.
struct PictureExtent {
    double width = 0.0;
    double height = 0.0;  ///< 0: as what is drawn asks for
    bool millimetres = false;
    friend bool operator==(const PictureExtent&, const PictureExtent&) = default;
};

/// How a view is laid on its picture: what frameViews() makes a camera and PictureSettings::size of.
struct FrameSettings {
    /// None: PictureSettings::size or, at a scale, what the drawing takes. PictureSettings::size counts, too, where
    /// this is a width and a height in pixels.
    std::optional<PictureExtent> size;
    std::optional<PictureLength> crop;  ///< cuts the picture to what is drawn and this margin, 0 or more
    /// Length on paper, at PictureSettings::dpi, of a length of the model; orthographic views. A model without a unit
    /// is in millimetres.
    std::optional<double> scale;
};

/// The pictures that a model is loaded for. The one that shows it the largest decides how fine the triangles of curved
/// surfaces are; other pictures can be drawn, too.
struct ExpectedPictures {
    std::vector<CameraSettings> cameras = {};  ///< none: one, as CameraSettings{}
    PictureSettings picture = {};
    FrameSettings frame = {};
};

/// What the loader makes of a file.
struct LoadSettings {
    Normals normals = Normals::Auto;
    Creases creases = Creases::Auto;
    /// Degrees, 0 to 180: faces that meet at more than this meet in a crease. Regular polygons of 10 and 11 sides bend
    /// by 36 and 32.7.
    double creaseAngle = 34.0;
    std::optional<int> scene = {};  ///< of a glTF's scenes; none: its default scene
    std::string animation = {};     ///< of a glTF's animations, by name or number; empty: its rest pose
    double time = 0.0;              ///< seconds into the animation, which holds its first and last pose beyond its ends
    Transparent transparent = Transparent::Solid;
    AlphaMask alphaMask = AlphaMask::Cut;
    BackFaces backFaces = BackFaces::Draw;
    int subdivide = 0;                ///< levels of refinement into a smooth surface, 0 to 6; 0: none
    bool textureCoordinates = false;  ///< Mesh::textureCoordinates is filled in: for isoparametric lines
    bool paint = false;               ///< Mesh::paint, Material::color and Material::picture are filled in; glTF only
    bool curvature = false;           ///< Mesh::curvatures is filled in
    /// Vertices that have no normal in the file get one. Lines between pixels and maps but those of normals need none:
    /// it is a third of the time that a scan takes. runJobs() knows what it draws, and leaves it out.
    bool completeNormals = true;
    LengthUnit unit = LengthUnit::None;  ///< of the model's coordinates; None: the format's, where it has one
    /// World space: which way is up of the model, whatever its length; none: SceneSource::up. See Scene::up().
    std::optional<glm::dvec3> up = {};
    /// Names of nodes, or patterns with * and ?. Nodes in which a pattern's node lies count, too: "arm" stands for all
    /// of the arm. Compared with a node's name and with its path, names from a root down with / between them.
    std::vector<std::string> only = {};  ///< these nodes alone are drawn; empty: all
    std::vector<std::string> hide = {};  ///< these are not
    LoadLimits limits = {};
    /// Pixels by which triangles stray from the curved surfaces of CAD files in the pictures that the model is loaded
    /// for, 0.001 to 100.
    double tolerance = 0.1;
    ExpectedPictures pictures = {};
};

/// Where the lines come from.
enum class LinesFrom {
    Auto,    ///< object space for vectors, image space for pictures
    Image,   ///< what a detector finds between neighbouring pixels
    Object,  ///< the mesh: edges and curves on faces, divided into seen and hidden parts; Hertzmann 1999, section 3
};
/// What stands for the contour of a surface, where it turns away from the eye.
enum class Contour {
    Auto,    ///< smooth where shading is smooth, edges where it is faceted
    Mesh,    ///< edges between a front-facing and a back-facing face, section 3.2
    Smooth,  ///< curves across faces where the interpolated normal is at right angles to the view, section 3.3
};
/// How the contour edges of a mesh are searched for, section 3.2.
enum class ContourFinder {
    Every,  ///< every edge is looked at
    /// Some edges are looked at, and those connected with a contour edge that was found. Quick on large meshes; may
    /// miss small contours.
    Random,
    /// A map of the edges' normals, made once, yields the edges near the contour. Orthographic views only.
    Gauss,
};
/// What becomes of hidden lines.
enum class HiddenLines { None, Dashed, Solid };
/// What becomes of lines that run along each other: 0.1 pixels apart or less, hidden ones their pen's width or 0.5.
enum class CoincidentLines {
    Merge,  ///< the nearest seen one stays, of the first type that any of the seen ones has; of hidden ones the nearest
    Keep,   ///< all stay
};
/// How wide a stroke is along its line, as a share of its type's width: 0.5 to 1.5 where it varies.
enum class StrokeWidth {
    Constant,
    Depth,      ///< wider where the line is nearer, between the nearest and the furthest of all lines
    Curvature,  ///< wider where it is straighter in the picture
    Strength,   ///< lines of form are narrower where they are weaker, down to nothing; others are constant
};

/// In which order the paths of an SVG, PDF or DXF stand.
enum class PathOrder {
    Drawn,   ///< by object, one path each
    Travel,  ///< so that a pen that draws them one after the other travels little between them; one path a line
};

/// Lines where a texture coordinate passes a multiple of 1 / steps; 0: none.
struct Isolines {
    int u = 0;  ///< 0 to 1000
    int v = 0;
    friend bool operator==(const Isolines&, const Isolines&) = default;
};

/// Which lines of form are drawn: LineType::Suggestive, ::Ridge, ::Valley and ::Apparent. How strong a line is at a
/// point has no unit: it is the feature size times what bends there, in 1 / length.
struct FormSettings {
    /// Percent, 0 to 20, of the radius of a sphere as large as the surface: what is smaller is roughness, which is
    /// smoothed away; 0: nothing is.
    double featureSize = 3.0;
    /// Lines stay if they are this strong somewhere, 0 to 100; 0: every line of the definition.
    double suggestiveThreshold = 0.08;
    double ridgeThreshold = 0.15;
    double apparentThreshold = 0.2;
    friend bool operator==(const FormSettings&, const FormSettings&) = default;
};

/// Lines from object space.
struct LineSettings {
    LinesFrom from = LinesFrom::Auto;
    Contour contour = Contour::Auto;
    ContourFinder contourFinder = ContourFinder::Every;
    HiddenLines hidden = HiddenLines::None;
    CoincidentLines coincident = CoincidentLines::Merge;
    double simplify = 0.25;  ///< pixels that polylines in files may deviate from those found; 0: every point is kept
    StrokeWidth strokeWidth = StrokeWidth::Constant;
    /// Pixels over which a free end of a line runs out to nothing. An end is free where no drawn line of any type goes
    /// on or meets it, as lines do in the corner of a solid. A line that runs behind another surface ends freely.
    double strokeTaper = 0.0;
    std::filesystem::path brush = {};  ///< a PNG, dark is ink, laid along lines from object space; empty: plain ink
    /// Pixels that cubic Bezier curves may deviate from the lines; 0: polylines; SVG, PDF, DXF.
    double fitCurves = 0.0;
    PathOrder pathOrder = PathOrder::Drawn;  ///< SVG, PDF, DXF
    int subdivideAdaptive = 0;               ///< levels of refinement near contours, section 3.3, 0 to 6; 0: none
    Isolines isolines = {};
    FormSettings form = {};
};

enum class Detector {
    Planes,          ///< where the planes of two visible faces do not go on into each other; needs no threshold
    Classic,         ///< gradients of the depth map and of the normal map, Hertzmann 1999, appendix A
    SaitoTakahashi,  ///< profiles and internal edges of the depth map, Saito and Takahashi 1990 (its reference 18)
    /// Back faces that are enlarged, and fins along creases, in one pass: Raskar and Cohen 1999 (its reference 17),
    /// Raskar 2001.
    RaskarCohen,
    None,  ///< no lines but those of DetectorSettings::functions
};
enum class Kernel : int {
    Sobel,  ///< 3 x 3, equation 5
    Farid,  ///< 5 x 5, equation 8
};
enum class DepthMap {
    Linear,  ///< eye-space depth scaled to 0..1 between near and far; background 1
    Window,  ///< window-space depth, 0 at near and 1 at far; background 1
};
enum class NormalLights {
    Single,   ///< six lights, three of them negative, in one pass into a float target
    TwoPass,  ///< the positive lights, then the negative ones, each into an 8-bit target; combined
};
enum class LightSpace { Camera, World };

struct DetectorSettings {
    Detector detector = Detector::Planes;
    Kernel kernel = Kernel::Sobel;
    DepthMap depthMap = DepthMap::Linear;
    std::optional<float> depthThreshold;   ///< T of equation 7 for the depth map; none: the kernel's default
    std::optional<float> normalThreshold;  ///< T of equation 7 for each normal channel; none: the kernel's default
    NormalLights normalLights = NormalLights::Single;
    LightSpace lightSpace = LightSpace::Camera;
    double profileLimit = 10.0;  ///< pixel footprints of depth over which a profile is full: k_p
    double edgeLimit = 0.6;      ///< change of slope over which an internal edge is full: k_l
    /// Surface functions whose edges are drawn over the detector's lines: section 2.1.3.
    std::vector<FunctionSettings> functions;
};

/// The thresholds in force: those given, else the defaults for the kernel in force.
struct Thresholds {
    float depth;
    float normal;
};
[[nodiscard]] INKEDGE_API Thresholds thresholds(const DetectorSettings&) noexcept;

/// How a whole picture is drawn: the effects of Hertzmann 1999, Figure 2, and its reference 5.
enum class Style {
    Ink,     ///< lines as they were found
    Hatch,   ///< lines and hatch marks between them, where facets of the mesh bend: edges of the faceted normal map
    Sumi,    ///< a soft brush instead of lines: gradients of depth and normals, smeared along the edges
    Pencil,  ///< lines drawn several times, each time a little off
    None,    ///< no lines: what is under them alone, or maps
};
struct StyleSettings {
    Style style = Style::Ink;
    /// Degrees, 0.1 to 90: facets that bend by this much give a dark mark in half light; none: the median bend of all
    /// edges within smooth surfaces of the scene, by their length.
    std::optional<double> hatchBend;
    double hatchShade = 1.0;       ///< 0 to 1: how much fewer marks there are in the light than in the dark
    double hatchWidth = 0.75;      ///< pixels, 0.25 to 2
    double sumiWidth = 6.0;        ///< pixels, 1 to 32: of the brush
    double sumiLength = 24.0;      ///< pixels, 0 to 100: how far ink is smeared along an edge, each way
    int sumiStreaks = 0;           ///< steps that depth is sampled in, each a streak; 0: none
    int pencilStrokes = 3;         ///< 1 to 8: times that a line is drawn
    double pencilLooseness = 3.0;  ///< pixels, 0 to 32: how far strokes deviate
    int pencilSeed = 1;            ///< of the random deviations: one seed gives the same ones in every picture
};

/// What fills surfaces under the lines. Of models that have no colours of their own the base colour is white.
enum class Shade {
    None,
    Flat,       ///< as Light, each face by its own normal
    Gooch,      ///< the base colour, from cool where it is turned from the light to warm: Gooch et al. 1998
    Light,      ///< the base colour, darker where it is turned from the light
    BaseColor,  ///< the base colour alone
};

/// Where the light of a Shade comes from, degrees; with LightSpace::Camera from the camera, 0, 0 being over its
/// shoulder; with LightSpace::World from the model's front, as CameraSettings count.
struct LightDirection {
    double azimuth = -35.0;   ///< towards the right, -360 to 360
    double elevation = 40.0;  ///< upwards, -90 to 90
    friend bool operator==(const LightDirection&, const LightDirection&) = default;
};

struct ShadeSettings {
    Shade shade = Shade::None;
    LightDirection light;  ///< on the axes of DetectorSettings::lightSpace
};

/// A map that a render can give beside the picture.
enum class Map { Depth, Normal, DepthEdges, NormalEdges, Edges, Types, Ids, Shade };
inline constexpr int mapCount = 8;

/// The name of a map on the command line, in file names and as EXR layer: "depth", "normal", "depth-edges", ...
[[nodiscard]] INKEDGE_API std::string_view name(Map) noexcept;

/// The axes of Maps::normal: x right, y up, z towards the eye; or those of the world.
enum class NormalSpace { Camera, World };

enum class Backend { Auto, Egl, Osmesa };

struct BackendSettings {
    Backend backend = Backend::Auto;
    std::optional<int> device;  ///< an EGL device's number, as `inkedge doctor` lists them
};

/// What a renderer is asked for: everything about a picture, but for its scene and its camera.
struct RenderSettings {
    PictureSettings picture;
    DetectorSettings detector;
    LineSettings lines;
    StyleSettings style;
    ShadeSettings shade;
    std::vector<Map> maps;
    NormalSpace normalSpace = NormalSpace::Camera;
};

/// Everything that can be set, from the file to the context. settingTable() describes each field once.
struct Settings : RenderSettings {
    LoadSettings load;
    CameraSettings camera;
    FrameSettings frame;
    BackendSettings backend;
};

/// How a model is to be loaded for pictures with these settings: Settings::load, and what their lines need besides.
[[nodiscard]] INKEDGE_API LoadSettings loadSettings(const Settings&);

}  // namespace inkedge
