#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/export.h>
#include <inkedge/image.h>
#include <inkedge/line_types.h>
#include <inkedge/lines.h>
#include <inkedge/settings.h>

namespace inkedge {

/// A polyline in a picture, of whatever source.
struct ComparedLine {
    std::optional<LineType> type;  ///< none: nothing is known of it, for it was found in a picture
    bool visible = true;
    bool closed = false;             ///< the last point is joined to the first, which is not repeated
    std::uint32_t object = 0;        ///< as Line::object; 0: not known
    std::vector<glm::dvec2> points;  ///< pixels, (0, 0) the picture's top left corner, y down; two or more
};

/// What is compared: the lines of one picture.
struct ComparedLines {
    std::vector<ComparedLine> lines;  ///< within the picture
    Size size;
    std::map<std::uint32_t, std::string> objects;  ///< names of objects, as NamedInstance::node
};

/// The lines, cut at the picture's edges.
[[nodiscard]] INKEDGE_API ComparedLines comparedLines(const Lines&);

/// The same of those that these settings draw, by their type and visibility.
[[nodiscard]] INKEDGE_API ComparedLines comparedLines(const Lines&, const RenderSettings&);

/// The middles of lines in a picture, whatever its fill: what is thinner than 17 pixels and darker than what is around
/// it, or lighter in a picture that is mostly dark. Positions are as exact as a tenth of a pixel, ends as half a line's
/// width. Lines that touch along their length are one.
/// @param picture  1, 3 or 4 channels, 0..1; alpha, the fourth, is over white
/// Pure, thread-safe, O(pixels).
/// Source: what stands out, Meyer's top hat, 1979; its skeleton, by taking simple pixels from one side after the other:
/// Rosenfeld, A characterization of parallel thinning algorithms, 1975, with the crossing number of Hilditch 1969.
[[nodiscard]] INKEDGE_API ComparedLines comparedLines(const Image<float>& picture);

/// The lines of a file: those of an SVG or JSON that this library wrote, else those in a picture of any format that
/// OpenImageIO reads. An SVG's are in coordinates of the document, so that drawing sheets are read, too.
/// @throws Error  (Kind::Input) if the file cannot be read, or is an SVG of outlines that are filled; the message
///                begins with its name
[[nodiscard]] INKEDGE_API ComparedLines readComparedLines(const std::filesystem::path&);

/// Whether hidden lines count.
enum class HiddenChanges {
    Count,
    Ignore,  ///< they count where they are seen on the other side
};

/// When the lines of two pictures count as the same.
struct LineTolerance {
    double distance = 1.5;  ///< pixels, over 0: lines that run along each other this near are the same
    double share = 0.0;     ///< 0..1: of the length of all lines, how much may have changed
    /// Pixels, 0 or more: shorter changes are left out and counted. Where lines end, meet or cross, and along the rims
    /// of a tolerance, samples decide over pieces that short.
    double speck = 4.0;
    HiddenChanges hidden = HiddenChanges::Count;
};

enum class LineChangeKind {
    Appeared,    ///< nothing ran along there before
    Vanished,    ///< nothing runs along there any more
    Moved,       ///< farther than the tolerance's distance, and at most four times that
    Visibility,  ///< hidden before and seen now, or the other way round
    Retyped,     ///< of another type than before
};

/// "appeared", "vanished", "moved", "visibility", "retyped".
[[nodiscard]] INKEDGE_API std::string_view name(LineChangeKind) noexcept;

/// One change: pieces of lines that belong together.
struct LineChange {
    LineChangeKind kind = LineChangeKind::Appeared;
    std::optional<LineType> type = {};  ///< now; of what vanished, as it was
    bool visible = true;
    std::optional<LineType> typeBefore = {};  ///< as type, but where type or visibility changed
    bool visibleBefore = true;
    std::uint32_t object = 0;
    std::string objectName = {};  ///< empty: not known
    double length = 0.0;          ///< pixels of lines; of what moved the longer of before and after
    /// Of what moved, pixels: how far, if by the same way all along, and else at the farthest, across the line.
    double distance = 0.0;
    /// That way, if it is the same all along: x right, y down. Of a straight line only what is across it is known.
    std::optional<glm::dvec2> way = {};
    std::vector<ComparedLine> before = {};  ///< none of what appeared
    std::vector<ComparedLine> after = {};   ///< none of what vanished
};

struct LinesComparison {
    Size size = {};
    LineTolerance tolerance = {};
    double lengthBefore = 0.0;  ///< pixels of all lines
    double lengthAfter = 0.0;
    double changedLength = 0.0;                ///< sum of LineChange::length
    double share = 0.0;                        ///< of the longer of both lengths; 0 where there are none
    std::vector<LineChange> changes = {};      ///< the longest first
    std::size_t specks = 0;                    ///< changes that were shorter than LineTolerance::speck
    double speckLength = 0.0;                  ///< pixels of these together
    std::vector<ComparedLine> unchanged = {};  ///< as they are after
    bool same = false;                         ///< the share is within the tolerance's
};

/// Compares lines: each is looked at every half pixel, and is where it was if a line of the other side within the
/// distance runs the same way, 35 degrees apart or less. What both sides know of type and visibility is compared, too.
/// Lines of one side that share one of the other within the distance count as the same.
/// @throws Error  (Kind::Usage) if the distance is not over 0 or over 100, or another number is negative or not finite;
///                (Kind::Input) if the sizes differ: the message gives both
/// Pure, thread-safe.
[[nodiscard]] INKEDGE_API LinesComparison compareLines(const ComparedLines& before, const ComparedLines& after,
                                                       const LineTolerance& = {});

/// The comparison as one JSON object; README.md describes it.
[[nodiscard]] INKEDGE_API std::string comparisonJson(const LinesComparison&);

/// A line a change, and what was left out: "moved  crease of plate, 62.8 px, by 2.0 px (2.0 right, 0.0 down), around
/// 120,80".
[[nodiscard]] INKEDGE_API std::string comparisonText(const LinesComparison&);

/// Refuses a name for writeComparison() before the work.
/// @param inputs  files that are compared
/// @throws Error  (Kind::Usage) if its extension is none of .svg, .pdf and .png, or it is one of the inputs
INKEDGE_API void expectComparisonFile(const std::filesystem::path&, std::span<const std::filesystem::path> inputs);

/// Draws a comparison as .svg, .pdf or .png: vanished lines are vermilion, those that appeared blue, what changed
/// otherwise is purple, also where it was; all others are grey.
/// @throws Error  (Kind::Usage) if the extension is another one; (Kind::Output) if the file cannot be written, or is to
///                be a PDF or PNG and Cairo is not there
INKEDGE_API void writeComparison(const LinesComparison&, const std::filesystem::path&);

}  // namespace inkedge
