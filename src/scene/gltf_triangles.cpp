#include "scene/gltf_triangles.h"

#include <array>

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

std::vector<std::uint32_t> triangleList(Mode mode, std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> triangles;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
    };
    const std::size_t step = mode == Mode::Triangles ? 3 : 1;
    for (std::size_t i = 0; i + 3 <= corners.size(); i += step) {
        const std::size_t odd = i % 2;
        if (mode == Mode::TriangleStrip)
            add(corners[i], corners[i + 1 + odd], corners[i + 2 - odd]);
        else if (mode == Mode::TriangleFan)
            add(corners[i + 1], corners[i + 2], corners[0]);
        else
            add(corners[i], corners[i + 1], corners[i + 2]);
    }
    return triangles;
}

}  // namespace inkedge::gltf
