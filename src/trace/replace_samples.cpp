#include "trace/replace_samples.h"

#include <algorithm>
#include <vector>

namespace inkedge::trace {
namespace {

struct Values {
    float plane[4];
    std::uint32_t triangle;
};

// What the surface seen at one sample would show at another one.
Values valuesFrom(const LineBuffers& buffers, SamplePosition from, SamplePosition at) {
    const float* const p = &buffers.planes(from.x, from.y);
    const auto dx = static_cast<float>(at.x - from.x);
    const auto dy = static_cast<float>(at.y - from.y);
    return {{p[0] + dx * p[1] + dy * p[2], p[1], p[2], p[3]}, buffers.triangles(from.x, from.y)};
}

class Marker {
public:
    Marker(LineBuffers& buffers, const raster::PlaneView& view, glm::dvec2 centre)
        : buffers_{buffers}, view_{view}, centre_{centre} {}

    void markAround(SamplePosition s) {
        put(s, rightMarks | belowMarks, right(s) | below(s));
        put({s.x - 1, s.y}, rightMarks, right({s.x - 1, s.y}));
        put({s.x, s.y - 1}, belowMarks, below({s.x, s.y - 1}));
    }

private:
    [[nodiscard]] raster::SeenPlane seen(SamplePosition s) const {
        const float* const p = &buffers_.planes(s.x, s.y);
        const raster::Rectangle& drawn = buffers_.tile.drawn;
        const glm::dvec2 fromCentre = glm::dvec2{s.x + drawn.x + 0.5, s.y + drawn.y + 0.5} - centre_;
        return {static_cast<double>(p[0]), {p[1], p[2]}, static_cast<double>(p[3]), fromCentre};
    }
    [[nodiscard]] unsigned right(SamplePosition p) const { return pairMarks(seen(p), seen({p.x + 1, p.y}), 0, view_); }
    [[nodiscard]] unsigned below(SamplePosition p) const {
        return pairMarks(seen(p), seen({p.x, p.y + 1}), 1, view_) << 4U;
    }
    void put(SamplePosition p, unsigned which, unsigned marks) {
        std::uint8_t& at = buffers_.marks(p.x, p.y);
        at = static_cast<std::uint8_t>((at & ~which) | marks);
    }

    LineBuffers& buffers_;
    const raster::PlaneView& view_;
    glm::dvec2 centre_;
};

}  // namespace

void replaceSamples(LineBuffers& buffers, const raster::PlaneView& view, glm::dvec2 centre,
                    std::span<const Replacement> replacements) {
    const Size size = buffers.marks.size();
    const auto isInside = [&](SamplePosition s) {
        return s.x > 0 && s.y > 0 && s.x + 1 < size.width && s.y + 1 < size.height;
    };
    // All are read before the first is written, so that their order does not matter.
    std::vector<Values> values;
    values.reserve(replacements.size());
    for (const auto& [at, from] : replacements) values.push_back(valuesFrom(buffers, from, at));
    for (std::size_t i = 0; i < replacements.size(); ++i) {
        const SamplePosition at = replacements[i].at;
        if (!isInside(at)) continue;
        std::copy_n(values[i].plane, 4, &buffers.planes(at.x, at.y));
        buffers.triangles(at.x, at.y) = values[i].triangle;
    }
    Marker marker{buffers, view, centre};
    for (const auto& [at, from] : replacements)
        if (isInside(at)) marker.markAround(at);
}

}  // namespace inkedge::trace
