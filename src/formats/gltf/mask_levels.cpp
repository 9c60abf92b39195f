#include "formats/gltf/mask_levels.h"

#include <algorithm>

#include "mesh/clip_polygon.h"
#include "mesh/cut_out.h"
#include "mesh/mask_detail.h"

namespace inkedge::gltf {
namespace {

// In corners that are cut, each of which takes about 20 microseconds until the picture is drawn.
constexpr double maxWork = 100'000.0;
constexpr double corner = 1.0;
constexpr double texel = 1.0 / 2000.0;           // looked at once
constexpr double interpolated = 1.0 / 300.0;     // a texel where the vertices' opacity changes
constexpr double cornerCutOff = 1.0 / 50.0;      // one beside a triangle, of an outline that is cut along
constexpr double cornerLookedAt = 1.0 / 1000.0;  // of a cell, for one triangle

// A mask at the resolution that is chosen so far.
struct Level {
    Mask mask;
    Mask half;
    double work = 0.0;
};

double workOf(const MaskUse& use, const Level& level) {
    const auto [width, height] = level.mask->size();
    const double texels = static_cast<double>(width) * height;
    const double corners = mesh::outlineCorners(*level.mask, *level.half, use.threshold);
    const double side = mesh::CutOut::cellSize;
    const double parts = use.area * texels / (side * side) + use.edges * std::max(width, height) / side;
    const double besideEach = corners / std::max(texels / (side * side), 1.0);  // in one cell
    const double looking = cornerCutOff * std::min(besideEach, double{mesh::longOutline}) + cornerLookedAt * besideEach;
    return use.area * (corner * corners + (use.varies ? interpolated : texel) * texels) + corner * parts +
           (use.triangles + parts) * looking;
}

void setMask(Level& level, Mask mask, std::uint64_t image, const std::vector<MaskUse>& uses) {
    level.mask = std::move(mask);
    level.half = std::make_shared<const inkedge::Image<std::uint8_t>>(mesh::halved(*level.mask));
    level.work = 0.0;
    for (const MaskUse& use : uses)
        if (use.image == image) level.work += workOf(use, level);
}

bool canBeHalved(const Level& level) { return level.mask->size() != level.half->size(); }

}  // namespace

std::map<std::uint64_t, Mask> coarserMasks(const std::vector<MaskUse>& uses, std::map<std::uint64_t, Mask> masks) {
    std::map<std::uint64_t, Level> levels;
    double work = 0.0;
    for (auto& [image, mask] : masks) {
        if (mask == nullptr) continue;
        setMask(levels[image], std::move(mask), image, uses);
        work += levels[image].work;
    }
    std::map<std::uint64_t, Mask> coarser;
    while (work > maxWork) {
        const auto largest = std::ranges::max_element(
            levels, {}, [](const auto& each) { return canBeHalved(each.second) ? each.second.work : 0.0; });
        auto& [image, level] = *largest;
        if (!canBeHalved(level)) break;
        work -= level.work;
        setMask(level, level.half, image, uses);
        work += level.work;
        coarser[image] = level.mask;
    }
    return coarser;
}

}  // namespace inkedge::gltf
