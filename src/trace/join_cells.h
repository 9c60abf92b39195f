#pragma once

#include <span>
#include <vector>

#include <inkedge/line_types.h>
#include <inkedge/settings.h>

#include "raster/tiles.h"
#include "trace/crossings.h"
#include "trace/traced_piece.h"

namespace inkedge::trace {

/// Which types of lines become pieces, and which of them have a pen of their own. A piece has the first of its types
/// that has one, else its first.
struct DrawnTypes {
    LineTypes drawn;
    LineTypes withPens;
};
[[nodiscard]] DrawnTypes drawnTypes(const PictureSettings&);

/// The type that a piece of these types, of which one is drawn, has.
[[nodiscard]] LineType drawnType(LineTypes, DrawnTypes);

/// Joins the crossings around each cell of 2 x 2 samples by pieces.
class CellJoiner {
public:
    /// @param tile    must outlive it, as must the pieces, which are added to
    CellJoiner(DrawnTypes, int samplesPerPixel, const raster::Tile& tile, std::vector<TracedPiece>&);

    /// The cells between two rows of crossings:
    ///        top
    ///   (x, y) --- (x + 1, y)
    ///  left |         | right
    ///       |         |
    ///        --------- bottom
    /// @param y  of the whole picture
    void join(int y, const CrossingRow& above, const CrossingRow& below);

private:
    void findCells(const std::vector<int>& above, const std::vector<int>& below);
    [[nodiscard]] LineType typeOf(const StepCrossing& c) const { return drawnType(c.types, types_); }
    void add(glm::vec2 from, glm::vec2 to, const StepCrossing&, float inverseDepthTo);
    void addBetween(const StepCrossing&, const StepCrossing&, int x, int y);
    // @return  the lines that are still to be joined
    std::span<const StepCrossing*> joinStrips(std::span<const StepCrossing*> strips,
                                              std::span<const StepCrossing*> lines, int x, int y);
    void joinCell(std::span<const StepCrossing*>, int x, int y);
    [[nodiscard]] glm::vec2 toBorder(const StepCrossing& end, const StepCrossing& other, int x, int y) const;

    DrawnTypes types_;
    float scale_;
    const raster::Tile& tile_;
    std::vector<TracedPiece>& pieces_;
    std::vector<int> upper_;  // cells that touch a crossing of the row above, ascending
    std::vector<int> cells_;  // those of either row
};

}  // namespace inkedge::trace
