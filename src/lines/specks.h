#pragma once

#include <vector>

#include <inkedge/lines.h>
#include <inkedge/scene.h>

namespace inkedge::lines {

inline constexpr double minLineLength = 0.1;   ///< pixels
inline constexpr double minScrapLength = 3.0;  ///< pixels
/// Pixels: a gap up to this does not part a line from another.
inline constexpr double scrapReach = 1.5;

/// Whether lines of a type may be scraps: what joins no other line is noise if it is short, as of folds of scanned
/// surfaces or of holes that are smaller than a pixel. What the file has, and isoparametric lines, are not.
[[nodiscard]] constexpr bool mayBeScrap(LineType type) {
    return type == LineType::Outline || type == LineType::Occlusion || type == LineType::Boundary ||
           type == LineType::Crease || type == LineType::Intersection || formLineTypes.contains(type);
}

/// Whether scraps are left out of a scene's lines: not with Creases::Angle, which asks for all lines of the definition.
[[nodiscard]] inline bool leavesOutScraps(const Scene& scene) { return scene.loadedWith().creases != Creases::Angle; }

/// Leaves out lines shorter than minLineLength: edges along the view, and scraps where lines end. O(points).
void leaveOutSpecks(std::vector<Line>&);

/// Leaves out scraps: lines that mayBeScrap(), are shorter than minScrapLength together with those like them that reach
/// their ends within scrapReach, and whose ends no other line reaches. The outline of an object stays if it has no
/// other line that does: it is something tiny. The order of the others stays.
/// O(pixels of length + n log n) for n short lines.
void leaveOutScraps(std::vector<Line>&);

}  // namespace inkedge::lines
