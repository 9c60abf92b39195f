#include "scene/gltf_triangles.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "scene/load_message.h"

namespace inkedge::gltf {

using namespace load;

std::string_view name(Mode mode) {
    constexpr std::array<std::string_view, 7> names{"POINTS",    "LINES",          "LINE_LOOP",   "LINE_STRIP",
                                                    "TRIANGLES", "TRIANGLE_STRIP", "TRIANGLE_FAN"};
    const int number = static_cast<int>(mode);
    if (number < 0 || number >= static_cast<int>(names.size()))
        refuse(fmt::format("expected a mode from 0 to 6, found {}", number));
    return names[static_cast<std::size_t>(number)];
}

namespace {

std::vector<std::uint32_t> wholeTriangles(std::vector<std::uint32_t> corners) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 3 <= corners.size(); i += 3) {
        const std::array triangle{corners[i], corners[i + 1], corners[i + 2]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
        for (const std::uint32_t corner : triangle) corners[kept++] = corner;
    }
    corners.resize(kept);
    return corners;
}

}  // namespace

std::vector<std::uint32_t> triangleList(Mode mode, std::vector<std::uint32_t> corners) {
    if (mode == Mode::Triangles) return wholeTriangles(std::move(corners));
    std::vector<std::uint32_t> triangles;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
    };
    for (std::size_t i = 0; i + 3 <= corners.size(); ++i) {
        const std::size_t odd = i % 2;
        if (mode == Mode::TriangleStrip)
            add(corners[i], corners[i + 1 + odd], corners[i + 2 - odd]);
        else
            add(corners[i + 1], corners[i + 2], corners[0]);
    }
    return triangles;
}

}  // namespace inkedge::gltf
