#include "lines/see/view_buffers.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

constexpr double beside = 0.75;         // pixels
constexpr double nearerByChance = 0.1;  // pixels across

bool isInside(Size size, glm::dvec2 place) {
    return place.x >= 0.0 && place.y >= 0.0 && place.x < size.width && place.y < size.height;
}

}  // namespace

bool isBackground(const ViewBuffers& buffers, glm::dvec2 place) {
    if (!isInside(buffers.triangles.size, place)) return false;
    return buffers.triangles.at(static_cast<int>(place.x), static_cast<int>(place.y)) == 0;
}

Guess guessVisibility(const ViewBuffers& buffers, const Screen& screen, const ScreenPoint& at, glm::dvec2 across,
                      std::span<const SceneFace> own, const Slack& slack) {
    const auto isOwn = [&](std::uint32_t number) {
        return std::ranges::any_of(own, [&](const SceneFace& face) {
            return face.instance < buffers.firstTriangles.size() &&
                   number == buffers.firstTriangles[face.instance] + face.triangle + 1;
        });
    };
    const auto slackAt = [&](std::uint32_t number) {
        if (slack.parts == nullptr) return slack.length;
        const auto after = std::ranges::upper_bound(buffers.firstTriangles, number - 1);
        const auto instance = static_cast<std::uint32_t>(after - buffers.firstTriangles.begin()) - 1;
        return slack.of({instance, number - 1 - buffers.firstTriangles[instance]});
    };
    const double scale = screen.orthographic() ? 1.0 / buffers.unit : buffers.unit;  // nearness in unit lengths
    int looked = 0;
    int hiding = 0;
    for (const double side : {0.0, beside, -beside}) {
        const glm::dvec2 place = at.place + side * across;
        if (!isInside(buffers.triangles.size, place)) continue;
        ++looked;
        const int x = static_cast<int>(place.x);
        const int y = static_cast<int>(place.y);
        const std::uint32_t number = buffers.triangles.at(x, y);
        if (number == 0 || isOwn(number)) continue;
        const double w = static_cast<double>(buffers.planes.at(x, y, 0));
        const glm::dvec2 gradient{buffers.planes.at(x, y, 1), buffers.planes.at(x, y, 2)};
        const glm::dvec2 offset = at.place - glm::dvec2{x + 0.5, y + 0.5};
        const double nearest = std::min(w, w + glm::dot(gradient, offset)) / scale;
        if (screen.footprintsBefore(nearest, at.nearness) > nearerByChance + slackAt(number)) ++hiding;
    }
    if (looked == 0) return Guess::Unsure;
    return hiding == 0 ? Guess::Seen : hiding == looked ? Guess::Hidden : Guess::Unsure;
}

}  // namespace inkedge::lines
