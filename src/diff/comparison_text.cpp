#include <inkedge/compare_lines.h>

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "io/metadata.h"

namespace inkedge {
namespace {

using io::Json;

std::string typeText(std::optional<LineType> type, bool visible) {
    return fmt::format("{}{}", visible ? "" : "hidden ", type ? name(*type) : std::string_view{"line"});
}

// What a change is about: its lines as they are, or as they were.
const std::vector<ComparedLine>& linesOf(const LineChange& change) {
    return change.after.empty() ? change.before : change.after;
}

// The middle of the rectangle around a change.
glm::dvec2 middleOf(const LineChange& change) {
    glm::dvec2 low{INFINITY};
    glm::dvec2 high{-INFINITY};
    for (const ComparedLine& line : linesOf(change)) {
        for (const glm::dvec2& point : line.points) {
            low = {std::fmin(low.x, point.x), std::fmin(low.y, point.y)};
            high = {std::fmax(high.x, point.x), std::fmax(high.y, point.y)};
        }
    }
    return 0.5 * (low + high);
}

std::string label(const LineChange& change) {
    return change.kind == LineChangeKind::Visibility ? (change.visible ? "now seen" : "now hidden")
                                                     : std::string{name(change.kind)};
}

std::string wayText(const LineChange& change) {
    if (!change.way) return fmt::format(", by up to {:.1f} px", change.distance);
    return fmt::format(", by {:.1f} px ({:.1f} {}, {:.1f} {})", change.distance, std::abs(change.way->x),
                       change.way->x < 0.0 ? "left" : "right", std::abs(change.way->y),
                       change.way->y < 0.0 ? "up" : "down");
}

std::string lineOf(const LineChange& change) {
    std::string text = fmt::format("  {:<10} {}", label(change), typeText(change.type, change.visible));
    if (!change.objectName.empty()) text += " of " + base::printable(change.objectName);
    if (change.kind == LineChangeKind::Retyped || change.kind == LineChangeKind::Visibility)
        text += fmt::format(", was {}", typeText(change.typeBefore, change.visibleBefore));
    text += fmt::format(", {:.1f} px", change.length);
    if (change.kind == LineChangeKind::Moved) text += wayText(change);
    const glm::dvec2 middle = middleOf(change);
    return text + fmt::format(", around {:.0f},{:.0f}\n", middle.x, middle.y);
}

double rounded(double value) { return std::round(value * 1e3) / 1e3 + 0.0; }  // + 0.0: never -0

Json polylines(const std::vector<ComparedLine>& lines) {
    Json all = Json::array();
    for (const ComparedLine& line : lines) {
        Json points = Json::array();
        for (const glm::dvec2& point : line.points) points.push_back({rounded(point.x), rounded(point.y)});
        all.push_back({{"closed", line.closed}, {"pixels", std::move(points)}});
    }
    return all;
}

Json typeJson(std::optional<LineType> type) { return type ? Json(name(*type)) : Json(nullptr); }

Json jsonOf(const LineChange& change) {
    Json json{{"change", name(change.kind)}, {"type", typeJson(change.type)}, {"visible", change.visible}};
    if (change.kind == LineChangeKind::Retyped || change.kind == LineChangeKind::Visibility) {
        json["type_before"] = typeJson(change.typeBefore);
        json["visible_before"] = change.visibleBefore;
    }
    json["object"] = change.object;
    json["name"] = io::validText(change.objectName);
    json["length"] = rounded(change.length);
    if (change.kind == LineChangeKind::Moved) {
        json["distance"] = rounded(change.distance);
        json["way"] = change.way ? Json{rounded(change.way->x), rounded(change.way->y)} : Json(nullptr);
    }
    if (!change.before.empty()) json["before"] = polylines(change.before);
    if (!change.after.empty()) json["after"] = polylines(change.after);
    return json;
}

}  // namespace

std::string comparisonText(const LinesComparison& comparison) {
    std::string text = fmt::format(
        "{}: {} change{} on {:.1f} of {:.1f} px of lines ({:.2f} %); within {:g} px lines are the same\n",
        comparison.same ? "same" : "different", comparison.changes.size(), comparison.changes.size() == 1 ? "" : "s",
        comparison.changedLength, std::max(comparison.lengthBefore, comparison.lengthAfter), 100.0 * comparison.share,
        comparison.tolerance.distance);
    for (const LineChange& change : comparison.changes) text += lineOf(change);
    if (comparison.specks > 0)
        text += fmt::format("  left out   {} speck{} under {:g} px, {:.1f} px together: ends and crossings of lines\n",
                            comparison.specks, comparison.specks == 1 ? "" : "s", comparison.tolerance.speck,
                            comparison.speckLength);
    return text;
}

std::string comparisonJson(const LinesComparison& comparison) {
    Json changes = Json::array();
    for (const LineChange& change : comparison.changes) changes.push_back(jsonOf(change));
    const Json json{{"same", comparison.same},
                    {"size", {comparison.size.width, comparison.size.height}},
                    {"distance", comparison.tolerance.distance},
                    {"length_before", rounded(comparison.lengthBefore)},
                    {"length_after", rounded(comparison.lengthAfter)},
                    {"changed_length", rounded(comparison.changedLength)},
                    {"changed_share", comparison.share},
                    {"left_out",
                     {{"count", comparison.specks},
                      {"length", rounded(comparison.speckLength)},
                      {"shorter_than", comparison.tolerance.speck},
                      {"why", "ends and crossings of lines"}}},
                    {"changes", std::move(changes)}};
    return io::textOf(json, -1) + "\n";
}

}  // namespace inkedge
