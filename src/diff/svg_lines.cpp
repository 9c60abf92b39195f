#include "diff/svg_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "settings/names.h"

namespace inkedge::diff {
namespace {

constexpr double largestSide = 1e5;  // pixels

// The numbers of a text, with blanks, commas or nothing between them, and letters among them.
class Numbers {
public:
    explicit Numbers(std::string_view text) : rest_{text} {}

    [[nodiscard]] bool atEnd() {
        const std::size_t start = rest_.find_first_not_of(" ,\t\r\n");
        rest_.remove_prefix(std::min(start, rest_.size()));
        return rest_.empty();
    }
    /// The letter that comes next; 0: a number does.
    [[nodiscard]] char letter() {
        if (atEnd() || !std::isalpha(static_cast<unsigned char>(rest_.front()))) return 0;
        const char found = rest_.front();
        rest_.remove_prefix(1);
        return found;
    }
    [[nodiscard]] double number() {
        double value = 0.0;
        if (!atEnd()) {
            const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
            if (error == std::errc{} && std::abs(value) <= 1e9) {
                rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
                return value;
            }
        }
        base::refuse(fmt::format("expected a number, found {}", base::quote(rest_.substr(0, 20))));
    }
    [[nodiscard]] glm::dvec2 point() {
        const double x = number();
        return {x, number()};
    }

private:
    std::string_view rest_;
};

// The value of an attribute of a tag; empty: it has none.
std::string_view attribute(std::string_view tag, std::string_view name) {
    const std::string start = fmt::format(" {}=\"", name);
    const std::size_t at = tag.find(start);
    if (at == std::string_view::npos) return {};
    const std::string_view value = tag.substr(at + start.size());
    return value.substr(0, value.find('"'));
}

std::string textOf(std::string_view escaped) {
    constexpr std::array<std::pair<std::string_view, char>, 4> entities{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&amp;", '&'}}};
    std::string text;
    while (!escaped.empty()) {
        const auto* const found =
            std::ranges::find_if(entities, [&](const auto& entity) { return escaped.starts_with(entity.first); });
        text += found == entities.end() ? escaped.front() : found->second;
        escaped.remove_prefix(found == entities.end() ? 1 : found->first.size());
    }
    return text;
}

void addCurve(std::vector<LinePoint>& points, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    constexpr double step = 4.0;  // pixels: a circle of 20 pixels strays by a tenth
    const double way = glm::distance(a, b) + glm::distance(b, c) + glm::distance(c, d);
    const int count = static_cast<int>(std::clamp(std::ceil(way / step), 2.0, 256.0));
    for (int i = 1; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        const double s = 1.0 - t;
        points.push_back({s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d, {}});
    }
}

// The subpaths of a path's data, as this library writes them: relative lines and curves.
void addPaths(std::string_view data, Line line, glm::dvec2 origin, std::vector<Line>& lines) {
    Numbers numbers{data};
    glm::dvec2 at{0.0};
    char command = 0;
    const auto finish = [&] {
        if (line.points.size() > 1) lines.push_back(line);
        line.points.clear();
        line.closed = false;
    };
    while (!numbers.atEnd()) {
        if (const char next = numbers.letter(); next != 0) command = next;
        switch (command) {
            case 'm':
                finish();
                at += numbers.point();
                line.points.push_back({at + origin, {}});
                command = 'l';
                break;
            case 'l':
                at += numbers.point();
                line.points.push_back({at + origin, {}});
                break;
            case 'h':
                at.x += numbers.number();
                line.points.push_back({at + origin, {}});
                break;
            case 'c': {
                const glm::dvec2 b = at + numbers.point();
                const glm::dvec2 c = at + numbers.point();
                const glm::dvec2 d = at + numbers.point();
                addCurve(line.points, at + origin, b + origin, c + origin, d + origin);
                at = d;
                break;
            }
            case 'z':
                if (line.points.empty()) base::refuse("path: expected a line before z, found none");
                at = line.points.front().pixel - origin;
                if (line.points.size() > 2) line.closed = true;
                finish();
                command = 0;
                break;
            default:
                base::refuse(fmt::format("path: expected m, l, h, c or z, as inkedge writes them, found {}",
                                         base::quote({&command, 1})));
        }
    }
    finish();
}

std::optional<LineType> typeOf(std::string_view classes) {
    constexpr std::string_view ours = "inkedge ";
    if (!classes.starts_with(ours)) return {};
    classes.remove_prefix(ours.size());
    const auto& names = settings::lineTypeNames;
    const auto* const found = std::ranges::find(names, classes.substr(0, classes.find(' ')));
    if (found == names.end()) return {};
    return static_cast<LineType>(1U << static_cast<unsigned>(found - names.begin()));
}

struct Group {
    std::optional<LineType> type;  // none: it is not compared
    bool visible = true;
    glm::dvec2 origin{0.0};
};

Group groupOf(std::string_view tag) {
    const std::string_view classes = attribute(tag, "class");
    Group group{typeOf(classes), classes.find(" visible") != std::string_view::npos};
    if (group.type && !attribute(tag, "fill").empty())
        base::refuse("expected lines, found outlines of them; draw without --stroke-width and --stroke-taper");
    constexpr std::string_view translate = "translate(";
    if (std::string_view moved = attribute(tag, "transform"); moved.starts_with(translate))
        group.origin = Numbers{moved.substr(translate.size())}.point();
    return group;
}

Size sizeOf(std::string_view tag) {
    Numbers box{attribute(tag, "viewBox")};
    const glm::dvec2 corner = box.point();
    const glm::dvec2 size = box.point();
    if (corner != glm::dvec2{0.0} || !(std::min(size.x, size.y) > 0.0 && std::max(size.x, size.y) <= largestSide))
        base::refuse(fmt::format("viewBox: expected 0 0 and a width and height of up to {} pixels, found {}",
                                 largestSide, base::quote(attribute(tag, "viewBox"))));
    return {static_cast<int>(std::ceil(size.x)), static_cast<int>(std::ceil(size.y))};
}

std::uint32_t objectOf(std::string_view text) {
    std::uint32_t object = 0;
    std::from_chars(text.data(), text.data() + text.size(), object);
    return object;
}

}  // namespace

ComparedLines linesOfSvg(std::string_view text) {
    const bool ours = text.find("class=\"inkedge ") != std::string_view::npos ||
                      text.find("<desc>Line drawing of a 3D model") != std::string_view::npos;
    if (!ours) base::refuse("expected an SVG that inkedge wrote, found another; compare it as a picture, a PNG");
    Lines all;
    std::map<std::uint32_t, std::string> names;
    Group group;
    while (true) {
        const std::size_t start = text.find('<');
        if (start == std::string_view::npos) break;
        const std::size_t end = text.find('>', start);
        if (end == std::string_view::npos) base::refuse("expected an SVG to its end, found it cut short");
        const std::string_view tag = text.substr(start + 1, end - start - 1);
        text.remove_prefix(end + 1);
        if (tag.starts_with("svg ")) {
            all.size = sizeOf(tag);
        } else if (tag.starts_with("g ")) {
            group = groupOf(tag);
        } else if (tag.starts_with("path ") && group.type) {
            const std::uint32_t object = objectOf(attribute(tag, "data-object"));
            if (const std::string_view named = attribute(tag, "data-name"); !named.empty())
                names[object] = textOf(named);
            Line line;
            line.type = *group.type;
            line.visible = group.visible;
            line.object = object;
            addPaths(attribute(tag, "d"), std::move(line), group.origin, all.lines);
        }
    }
    if (all.size.width == 0) base::refuse("expected an SVG with a viewBox, found none");
    ComparedLines compared = comparedLines(all);  // cut at the picture's edges
    compared.objects = std::move(names);
    return compared;
}

}  // namespace inkedge::diff
