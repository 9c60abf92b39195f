#include "render/map_beside.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "curves/clip.h"
#include "lines/object_lines.h"

namespace inkedge::render {
namespace {

void mark(glm::dvec2 pixel, LineType type, Maps& maps) {
    const auto set = [&](auto& image, auto value) {
        const auto [width, height] = image.size();
        const int x = std::clamp(static_cast<int>(std::floor(pixel.x)), 0, width - 1);
        const int y = std::clamp(static_cast<int>(std::floor(pixel.y)), 0, height - 1);
        image(x, y) |= value;
    };
    if (!maps.types.empty()) set(maps.types, static_cast<std::uint16_t>(LineTypes{type}.bits()));
    if (!maps.edges.empty()) set(maps.edges, std::uint8_t{255});
}

}  // namespace

void mapBeside(const Lines& lines, LineTypes drawn, Maps& maps) {
    constexpr double step = 0.5;  // pixels
    for (const Line& line : lines.lines) {
        if (!line.visible || !(drawn & lines::typesAddedToMaps).contains(line.type)) continue;
        for (const Line& part : curves::clip(line, glm::dvec2{0.0}, {lines.size.width, lines.size.height})) {
            const std::size_t count = part.points.size();
            for (std::size_t i = 0; i + (part.closed ? 0 : 1) < count; ++i) {
                const glm::dvec2 from = part.points[i].pixel;
                const glm::dvec2 to = part.points[(i + 1) % count].pixel;
                const double steps = std::max(1.0, std::ceil(glm::distance(from, to) / step));
                for (double k = 0.0; k <= steps; ++k) mark(glm::mix(from, to, k / steps), line.type, maps);
            }
        }
    }
}

}  // namespace inkedge::render
