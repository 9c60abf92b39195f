#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <inkedge/encode_png.h>
#include <inkedge/export.h>
#include <inkedge/lines.h>
#include <inkedge/maps.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>
#include <inkedge/write_file.h>

namespace inkedge {

/// What metadata name besides.
struct ViewFiles {
    std::string model;                         ///< its file, as it was given; empty: none
    std::string view;                          ///< View::name; empty: none
    std::vector<std::filesystem::path> files;  ///< that hold what was drawn
};

/// What a render was asked for and what it did, as one JSON object: the names given; camera (view and projection as
/// row-major 4 x 4 for column vectors, OpenGL clip space; world_to_camera and K as OpenCV has them; near, far); size,
/// dpi, bounds, up, instances and materials by id, settings, backend, GL strings, milliseconds of each stage. README.md
/// describes it.
[[nodiscard]] INKEDGE_API std::string metadataJson(const Scene&, const Maps&, const Settings&, const ViewFiles& = {});

/// The same for lines, which know no up; instances are those that lines lie on.
[[nodiscard]] INKEDGE_API std::string metadataJson(const Lines&, const Settings&, const ViewFiles& = {});

/// Instances and materials as one JSON object on one line, as metadata have them and EXR's inkedge:names.
[[nodiscard]] INKEDGE_API std::string namesJson(const SceneNames&);

/// The files that writeMaps() writes: first the picture's, then one for each map if the format holds one map a file,
/// four for the ids: "ids-patch", "ids-across", "ids-object", "ids-material". "{map}" in output stands for "outline" or
/// the map's name; without it a map's name goes before the extension ("gear.png", "gear.depth.png"). Formats by
/// extension: .png, .tif, .tiff; .exr and .npz hold every map in one file.
/// @throws Error  (Kind::Usage) if the extension is none of these: the message lists them, and those of lines
[[nodiscard]] INKEDGE_API std::vector<std::filesystem::path> outputFiles(const std::filesystem::path& output,
                                                                         std::span<const Map> maps);

/// Writes the picture and the named maps; every file appears whole or not at all. README.md's "Maps" says what each
/// format makes of each map. PNG: depth as grey of 16 bits from near (0) to far (65535), types and ids as grey of 16
/// bits, normals as (n + 1) / 2 of 8 bits, edges black on white, the shade as it is. TIFF: floats, but the shade. EXR:
/// floats, in layers depth.Z, normal.X/Y/Z, depth-edges.Y, normal-edges.Y, edges.Y, types.V, patch.V, across.V,
/// object.V, material.V and shade.R/G/B/A, beside the picture's R, G, B and, of four channels, A (both in linear light,
/// premultiplied); inkedge:near, inkedge:far, inkedge:view, inkedge:projection and, with ids, inkedge:names in its
/// header. NPZ: arrays named as the maps, with _ for -, and "picture", "view", "projection", "world_to_camera", "K",
/// "near", "far" and, with ids, "instance_names" and "material_names" by id.
/// @return        the files written, as outputFiles() gives them
/// @throws Error  (Kind::Output) if one cannot be written, or ids are over 65535 in a PNG, or over 16777216 in an EXR
///                or TIFF; none is left half-written
INKEDGE_API std::vector<std::filesystem::path> writeMaps(const Maps&, std::span<const Map> maps,
                                                         const std::filesystem::path& output);

/// The maps that a file of this name holds where none are asked for: of an .npz all that belong to a data set.
[[nodiscard]] INKEDGE_API std::vector<Map> defaultMaps(const std::filesystem::path& output);

/// The lines as an SVG document: those whose types settings.picture.lines names, hidden ones if settings.lines.hidden
/// wants them, cut at the picture's edges (and half a width beyond), as polylines or curves within
/// settings.lines.simplify, less Lines::tolerance, or .fitCurves. Its coordinates are pixels of lines.size; its width
/// and height are the page's, or pixels, or millimetres where a width or settings.picture.dpi says so; on a page of
/// another shape the drawing is moved to the middle. One group a type and visibility, what covers last, with the
/// classes "inkedge", the type's name, "visible" or "hidden", and both as in "crease-hidden", by which it is a layer of
/// Inkscape's, too; in it one path an object, or more where one would have over 32,000 points, whose data-object is
/// Line::object and whose data-name is NamedInstance::node; with PathOrder::Travel one path a line, in an order of
/// short ways, also from one group to the next. Where widths vary a path is the filled outline of its strokes, all
/// straight. Lines::shade is an image under them, a PNG in the document. Metadata holds a JSON object: camera, size,
/// bounds, settings.
/// @param title  UTF-8; what is not becomes U+FFFD
/// @throws Error  (Kind::Usage) if lines.size has no pixel, or settings.lines.brush is given: it needs pixels
[[nodiscard]] INKEDGE_API std::string linesSvg(const Lines&, const Settings&, std::string_view title = "Line drawing");

/// The same drawing as a PDF of one page: of the page's size, or a pixel 1 / dpi inch wide. It has no date: the same
/// lines and settings give the same bytes.
/// @throws Error  as linesSvg(); (Kind::Output) if the module for PDF, or Cairo, is not there
[[nodiscard]] INKEDGE_API std::vector<std::uint8_t> linesPdf(const Lines&, const Settings&,
                                                             std::string_view title = "Line drawing");

/// The same lines as a DXF (ASCII, AC1015), in millimetres, y up, (0, 0) the lower left corner: one layer a type and
/// visibility, "crease-hidden", with the nearest of DXF's colours and line widths; polylines, curves within a twentieth
/// of a pixel. An orthographic view is as large as the model, unless settings ask for a size on paper: a page, a scale,
/// a size or a crop in millimetres; then, and in perspective, it is as large as the SVG. A model without a unit is in
/// millimetres. Lines are as wide as their pens whatever the settings say of strokes; nothing is drawn under them.
/// @throws Error  as linesSvg()
[[nodiscard]] INKEDGE_API std::string linesDxf(const Lines&, const Settings&);

/// The same lines, not cut, as one JSON object, which linesFromJson() reads: README.md describes it. "pixels" are
/// rounded to 0.001, "positions" to a millionth of the bounds' radius. Points that are not finite are left
/// out. Lines are simplified by what settings.lines.simplify leaves over Lines::tolerance: what was read and is written
/// with the same settings comes to the same bytes. Backend and times are not written.
/// @throws Error  (Kind::Usage) if lines.size has no pixel, or camera, bounds or tolerance are not finite
[[nodiscard]] INKEDGE_API std::string linesJson(const Lines&, const Settings&);

/// Whether a file of this name holds lines rather than pixels: its extension is .svg, .pdf, .dxf or
/// .json, in whatever case.
[[nodiscard]] INKEDGE_API bool holdsLines(const std::filesystem::path&);

/// Writes linesSvg(), linesPdf(), linesDxf() or linesJson(), by the extension; the title of an SVG or PDF is the file's
/// name. The file appears whole or not at all.
/// @throws Error  (Kind::Usage) as they do, or if the extension is none of these; (Kind::Output) if the file cannot
///                be written
INKEDGE_API void writeLines(const Lines&, const Settings&, const std::filesystem::path&);

}  // namespace inkedge
