#include "formats/gltf/triangles.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

std::string_view name(Mode mode) {
    constexpr std::array<std::string_view, 7> names{"POINTS",    "LINES",          "LINE_LOOP",   "LINE_STRIP",
                                                    "TRIANGLES", "TRIANGLE_STRIP", "TRIANGLE_FAN"};
    const int number = static_cast<int>(mode);
    if (number < 0 || number >= static_cast<int>(names.size()))
        base::refuse(fmt::format("expected a mode from 0 to 6, found {}", number));
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

// How many triangles corners without a restart make.
std::size_t triangleCount(Mode mode, std::size_t corners) {
    return mode == Mode::Triangles ? corners / 3 : corners < 3 ? 0 : corners - 2;
}

// Calls visit(number, a, b, c) for each triangle without a repeated index, of corners without a restart.
template <class Visit>
void forEachTriangleOfRun(Mode mode, std::span<const std::uint32_t> corners, Visit&& visit) {
    const auto add = [&](std::size_t number, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) visit(number, a, b, c);
    };
    const std::size_t step = mode == Mode::Triangles ? 3 : 1;
    for (std::size_t i = 0; i + 3 <= corners.size(); i += step) {
        const std::size_t odd = i % 2;
        if (mode == Mode::TriangleStrip)
            add(i, corners[i], corners[i + 1 + odd], corners[i + 2 - odd]);
        else if (mode == Mode::TriangleFan)
            add(i, corners[i + 1], corners[i + 2], corners[0]);
        else
            add(i / 3, corners[i], corners[i + 1], corners[i + 2]);
    }
}

template <class Visit>
void forEachTriangle(Mode mode, std::span<const std::uint32_t> corners, Visit&& visit) {
    std::size_t before = 0;
    for (const std::span<const std::uint32_t> run : runsOf(corners)) {
        forEachTriangleOfRun(mode, run, [&](std::size_t number, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            visit(static_cast<std::uint32_t>(before + number), a, b, c);
        });
        before += triangleCount(mode, run.size());
    }
}

}  // namespace

std::vector<std::span<const std::uint32_t>> runsOf(std::span<const std::uint32_t> corners) {
    std::vector<std::span<const std::uint32_t>> runs;
    for (std::size_t begin = 0; begin < corners.size();) {
        const auto rest = corners.subspan(begin);
        const auto length = static_cast<std::size_t>(std::ranges::find(rest, restart) - rest.begin());
        if (length > 0) runs.push_back(rest.first(length));
        begin += length + 1;
    }
    return runs;
}

std::size_t triangleCount(Mode mode, std::span<const std::uint32_t> corners) {
    std::size_t count = 0;
    for (const std::span<const std::uint32_t> run : runsOf(corners)) count += triangleCount(mode, run.size());
    return count;
}

std::vector<std::uint32_t> triangleList(Mode mode, std::vector<std::uint32_t> corners) {
    if (mode == Mode::Triangles) return wholeTriangles(std::move(corners));
    std::vector<std::uint32_t> triangles;
    forEachTriangle(mode, corners, [&](std::uint32_t, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles.insert(triangles.end(), {a, b, c});
    });
    return triangles;
}

std::vector<std::uint32_t> triangleNumbers(Mode mode, std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> numbers;
    forEachTriangle(mode, corners, [&](std::uint32_t number, std::uint32_t, std::uint32_t, std::uint32_t) {
        numbers.push_back(number);
    });
    return numbers;
}

}  // namespace inkedge::gltf
