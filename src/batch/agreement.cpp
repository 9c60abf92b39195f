#include "batch/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "curves/clip.h"

namespace inkedge::batch {
namespace {

constexpr double step = 0.5;  // pixels between points of a line that are looked at

struct Segment {
    glm::dvec2 a;
    glm::dvec2 b;
};

double squaredDistance(const Segment& segment, glm::dvec2 point) {
    const glm::dvec2 along = segment.b - segment.a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(point - segment.a, along) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec2 away = point - (segment.a + t * along);
    return glm::dot(away, away);
}

std::vector<Segment> segmentsOf(const Lines& lines) {
    std::vector<Segment> segments;
    for (const Line& line : lines.lines) {
        if (!line.visible) continue;
        for (const Line& part : curves::clip(line, glm::dvec2{0.0}, {lines.size.width, lines.size.height})) {
            const std::size_t count = part.points.size();
            for (std::size_t i = 0; i + (part.closed ? 0 : 1) < count; ++i)
                segments.push_back({part.points[i].pixel, part.points[(i + 1) % count].pixel});
        }
    }
    return segments;
}

// Segments, found again by the cells of the picture that they pass within reach of.
class Grid {
public:
    Grid(std::span<const Segment> segments, Size size)
        : segments_{segments}, columns_{size.width / cell + 1}, rows_{size.height / cell + 1} {
        cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const auto [a, b] = segments[i];
            const glm::ivec2 low = cellOf(glm::min(a, b) - agreementReach);
            const glm::ivec2 high = cellOf(glm::max(a, b) + agreementReach);
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) cells_[indexOf({x, y})].push_back(i);
        }
    }

    [[nodiscard]] bool hasNear(glm::dvec2 point) const {
        return std::ranges::any_of(cells_[indexOf(cellOf(point))], [&](std::uint32_t i) {
            return squaredDistance(segments_[i], point) <= agreementReach * agreementReach;
        });
    }

private:
    static constexpr int cell = 8;  // pixels
    [[nodiscard]] glm::ivec2 cellOf(glm::dvec2 point) const {
        return glm::clamp(glm::ivec2{glm::floor(point / static_cast<double>(cell))}, glm::ivec2{0},
                          glm::ivec2{columns_ - 1, rows_ - 1});
    }
    [[nodiscard]] std::size_t indexOf(glm::ivec2 at) const {
        return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(at.x);
    }

    std::span<const Segment> segments_;
    int columns_;
    int rows_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

// The length of all segments, and of what of them is near to others.
std::pair<double, double> lengthsNear(std::span<const Segment> segments, const Grid& others) {
    double all = 0.0;
    double near = 0.0;
    for (const auto& [a, b] : segments) {
        const double length = glm::distance(a, b);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
        for (int i = 0; i < pieces; ++i) {
            all += length / pieces;
            if (others.hasNear(glm::mix(a, b, (i + 0.5) / pieces))) near += length / pieces;
        }
    }
    return {all, near};
}

}  // namespace

double Agreement::f1() const noexcept {
    const double sum = precision() + recall();
    return sum > 0.0 ? 2.0 * precision() * recall() / sum : 0.0;
}

Agreement& Agreement::operator+=(const Agreement& other) noexcept {
    image += other.image;
    imageNear += other.imageNear;
    object += other.object;
    objectNear += other.objectNear;
    return *this;
}

Agreement agreementOf(const Lines& image, const Lines& object) {
    const std::vector<Segment> ofImage = segmentsOf(image);
    const std::vector<Segment> ofObject = segmentsOf(object);
    Agreement agreement;
    std::tie(agreement.image, agreement.imageNear) = lengthsNear(ofImage, Grid{ofObject, object.size});
    std::tie(agreement.object, agreement.objectNear) = lengthsNear(ofObject, Grid{ofImage, image.size});
    return agreement;
}

}  // namespace inkedge::batch
