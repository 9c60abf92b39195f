#include <inkedge/compare_lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "curves/clip.h"
#include "diff/changes.h"
#include "diff/match.h"
#include "settings/pens.h"

namespace inkedge {
namespace {

constexpr double movedReach = 4.0;  // distances: what lies farther apart is no line that moved

void expectUsable(const ComparedLines& before, const ComparedLines& after, const LineTolerance& tolerance) {
    const auto refuse = [](std::string_view name, std::string_view expected, double found) {
        throw Error{Error::Kind::Usage, fmt::format("{}: expected {}, found {}", name, expected, found)};
    };
    if (!(tolerance.distance > 0.0 && tolerance.distance <= 100.0))
        refuse("distance", "a number over 0 and at most 100", tolerance.distance);
    if (!(tolerance.share >= 0.0 && tolerance.share <= 1.0)) refuse("share", "a number from 0 to 1", tolerance.share);
    if (!(tolerance.speck >= 0.0 && std::isfinite(tolerance.speck)))
        refuse("speck", "a number from 0", tolerance.speck);
    if (before.size != after.size)
        throw Error{Error::Kind::Input,
                    fmt::format("expected two pictures of one size, found {} x {} and {} x {} pixels; draw both with "
                                "one --size",
                                before.size.width, before.size.height, after.size.width, after.size.height)};
}

template <class Keeps>
ComparedLines comparedLinesThat(const Lines& lines, Keeps keeps) {
    ComparedLines all{.lines = {}, .size = lines.size, .objects = {}};
    for (const NamedInstance& instance : lines.names.instances) all.objects.emplace(instance.id, instance.node);
    for (const Line& line : lines.lines) {
        if (!keeps(line)) continue;
        for (const Line& part : curves::clip(line, glm::dvec2{0.0}, {lines.size.width, lines.size.height})) {
            ComparedLine& added =
                all.lines.emplace_back(ComparedLine{line.type, line.visible, part.closed, line.object, {}});
            for (const LinePoint& point : part.points) added.points.push_back(point.pixel);
        }
    }
    return all;
}

}  // namespace

std::string_view name(LineChangeKind kind) noexcept {
    constexpr std::array<std::string_view, 5> names{"appeared", "vanished", "moved", "visibility", "retyped"};
    return names[static_cast<std::size_t>(kind)];
}

ComparedLines comparedLines(const Lines& lines) {
    return comparedLinesThat(lines, [](const Line&) { return true; });
}

ComparedLines comparedLines(const Lines& lines, const RenderSettings& settings) {
    return comparedLinesThat(
        lines, [&](const Line& line) { return settings::isDrawn(line, settings.picture, settings.lines); });
}

LinesComparison compareLines(const ComparedLines& before, const ComparedLines& after, const LineTolerance& tolerance) {
    expectUsable(before, after, tolerance);
    LinesComparison comparison{.size = before.size, .tolerance = tolerance};
    diff::Side old{before, tolerance.distance, movedReach * tolerance.distance};
    diff::Side now{after, tolerance.distance, movedReach * tolerance.distance};
    const std::vector<diff::LineMove> moves = diff::matchSides(old, now, tolerance.distance);
    diff::collectChanges(old, now, moves, comparison);

    for (LineChange& change : comparison.changes) {
        const auto& names = change.kind == LineChangeKind::Vanished ? before.objects : after.objects;
        if (const auto known = names.find(change.object); known != names.end()) change.objectName = known->second;
        comparison.changedLength += change.length;
    }
    std::ranges::stable_sort(comparison.changes, std::greater{}, &LineChange::length);
    const double all = std::max(comparison.lengthBefore, comparison.lengthAfter);
    comparison.share = all > 0.0 ? std::min(comparison.changedLength / all, 1.0) : 0.0;
    comparison.same = comparison.share <= tolerance.share;
    return comparison;
}

}  // namespace inkedge
