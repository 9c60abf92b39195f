#include "trace/pinholes.h"

#include <cmath>

namespace inkedge::trace {
namespace {

class PinholeFilter {
public:
    PinholeFilter(LineBuffers& buffers, const Camera& camera, double unit)
        : buffers_{buffers},
          orthographic_{camera.orthographic()},
          focalLengths_{camera.focalLengths(buffers.tile.whole) * (camera.orthographic() ? unit : 1.0)} {}

    void apply() {
        const Size size = buffers_.marks.size();
        for (int y = 1; y + 1 < size.height; ++y) {
            forEachMarked(buffers_.marks, y, 1, size.width - 1, [&](int x) {
                if (!standsAlone(x, y) || !isPinhole(x, y)) return;
                buffers_.marks(x, y) = 0;
                buffers_.marks(x - 1, y) &= belowMarks;
                buffers_.marks(x, y - 1) &= rightMarks;
            });
        }
    }

private:
    [[nodiscard]] bool standsAlone(int x, int y) const {
        const unsigned own = buffers_.marks(x, y);
        return (own & rightMarks) != 0 && (own & belowMarks) != 0 && (buffers_.marks(x - 1, y) & rightMarks) != 0 &&
               (buffers_.marks(x, y - 1) & belowMarks) != 0;
    }

    [[nodiscard]] double plane(int x, int y, int channel) const {
        return static_cast<double>(buffers_.planes(x, y, channel));
    }

    // Whether the two samples beside (x, y) along an axis see one patch that goes on from one to the other in front of
    // (x, y).
    [[nodiscard]] bool coveredAlong(int x, int y, int dx, int dy) const {
        const double patch = plane(x - dx, y - dy, 3);
        if (patch == 0.0 || patch != plane(x + dx, y + dy, 3)) return false;
        const int axis = dx != 0 ? 1 : 2;
        const double before = plane(x - dx, y - dy, 0) + plane(x - dx, y - dy, axis);
        const double after = plane(x + dx, y + dy, 0) - plane(x + dx, y + dy, axis);
        const double k = focalLengths_[axis - 1] / (orthographic_ ? 1.0 : std::max(before, after));
        const double slope = std::min(std::abs(plane(x - dx, y - dy, axis)), std::abs(plane(x + dx, y + dy, axis)));
        if (std::abs(before - after) * k > 1.0 + slope * k) return false;
        return plane(x, y, 3) == 0.0 || plane(x, y, 0) < std::min(before, after);
    }

    [[nodiscard]] bool isPinhole(int x, int y) const {
        return plane(x - 1, y, 3) == plane(x, y - 1, 3) && coveredAlong(x, y, 1, 0) && coveredAlong(x, y, 0, 1);
    }

    LineBuffers& buffers_;
    bool orthographic_;
    glm::dvec2 focalLengths_;
};

}  // namespace

void removePinholes(LineBuffers& buffers, const Camera& camera, double unit) {
    PinholeFilter{buffers, camera, unit}.apply();
}

}  // namespace inkedge::trace
