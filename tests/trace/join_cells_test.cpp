#include "trace/join_cells.h"

#include <gmock/gmock.h>

namespace inkedge::trace {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr Size size{8, 6};
const raster::Tile whole{size};

StepCrossing crossingAt(glm::vec2 position, LineTypes types = LineType::Crease) {
    return {position, types, 0.5F, {0, 7}};
}

// A row of samples whose steps to the right are crossed at these columns.
CrossingRow crossedRight(const std::vector<std::pair<int, StepCrossing>>& crossings) {
    CrossingRow row{size.width};
    for (const auto& [column, crossing] : crossings) {
        row.right[static_cast<std::size_t>(column)] = crossing;
        row.columns.push_back(column);
    }
    return row;
}

std::vector<TracedPiece> joined(int y, const CrossingRow& above, const CrossingRow& below, DrawnTypes types,
                                int samplesPerPixel = 1) {
    std::vector<TracedPiece> pieces;
    CellJoiner{types, samplesPerPixel, whole, pieces}.join(y, above, below);
    return pieces;
}

const DrawnTypes all{standardLineTypes, {}};

TEST(JoinCells, joinsTwoCrossingsByOnePiece) {
    const CrossingRow above = crossedRight({{3, crossingAt({3.75F, 2.5F})}});
    const CrossingRow below = crossedRight({{3, crossingAt({4.25F, 3.5F})}});
    const auto pieces = joined(2, above, below, all);
    ASSERT_THAT(pieces, SizeIs(1));
    EXPECT_EQ(pieces[0].ends, (std::array{glm::vec2{3.75F, 2.5F}, glm::vec2{4.25F, 3.5F}}));
    EXPECT_EQ(pieces[0].inverseDepths, (std::array{0.5F, 0.5F}));
    EXPECT_EQ(pieces[0].type, LineType::Crease);
    EXPECT_EQ(pieces[0].face, (scene::SceneFace{0, 7}));
    EXPECT_EQ(joined(2, above, below, all, 2).at(0).ends[0], glm::vec2(1.875F, 1.25F)) << "output pixels";
}

TEST(JoinCells, meetsOtherTypesInTheMiddle) {
    const auto pieces = joined(2, crossedRight({{3, crossingAt({4.0F, 2.5F}, LineType::Outline)}}),
                               crossedRight({{3, crossingAt({4.0F, 3.5F})}}), all);
    ASSERT_THAT(pieces, SizeIs(2));
    EXPECT_EQ(pieces[0].ends[1], glm::vec2(4.0F, 3.0F));
    EXPECT_EQ(pieces[1].ends[1], glm::vec2(4.0F, 3.0F));
    EXPECT_NE(pieces[0].type, pieces[1].type);
}

TEST(JoinCells, leavesOutTypesThatAreNotDrawn) {
    const CrossingRow above = crossedRight({{3, crossingAt({4.0F, 2.5F}, LineType::Outline)}});
    const CrossingRow below = crossedRight({{3, crossingAt({4.0F, 3.5F})}});
    EXPECT_THAT(joined(2, above, below, {LineType::Boundary, {}}), IsEmpty());
    const auto alone = joined(2, above, below, {LineType::Outline, {}});
    ASSERT_THAT(alone, SizeIs(1));
    EXPECT_EQ(alone[0].ends[0], alone[0].ends[1]) << "a dot: nothing goes on";
}

TEST(JoinCells, prefersATypeWithAPenOfItsOwn) {
    const LineTypes both = LineType::Outline | LineType::Boundary;
    const CrossingRow above = crossedRight({{3, crossingAt({4.0F, 2.5F}, both)}});
    const CrossingRow below = crossedRight({{3, crossingAt({4.0F, 3.5F}, both)}});
    EXPECT_EQ(joined(2, above, below, all).at(0).type, LineType::Outline);
    EXPECT_EQ(joined(2, above, below, {standardLineTypes, LineType::Boundary}).at(0).type, LineType::Boundary);
}

TEST(JoinCells, joinsCreasesOfStripsBesideTheOtherLine) {
    CrossingRow above = crossedRight({{3, crossingAt({3.75F, 2.5F}, LineType::Outline)}});
    CrossingRow below = crossedRight({{3, crossingAt({3.75F, 3.5F}, LineType::Outline)}});
    const auto strip = [](glm::vec2 position) {
        StepCrossing crossing = crossingAt(position);
        crossing.width = 0.25F;
        return crossing;
    };
    above.rightStrips[3] = strip({3.5F, 2.5F});
    below.rightStrips[3] = strip({3.5F, 3.5F});
    const auto pieces = joined(2, above, below, all);
    ASSERT_THAT(pieces, SizeIs(2));
    EXPECT_EQ(pieces[1].width, 1.0F);
    EXPECT_EQ(pieces[0].type, LineType::Crease);
    EXPECT_EQ(pieces[0].width, 0.25F);
    EXPECT_EQ(pieces[0].ends, (std::array{glm::vec2{3.5F, 2.5F}, glm::vec2{3.5F, 3.5F}}));
    EXPECT_THAT(joined(2, above, below, {LineType::Outline, {}}), SizeIs(1)) << "creases are not drawn";

    // Where the strip is wider its crease goes on as any other.
    below.rightStrips[3].types = {};
    below.right[3] = crossingAt({3.5F, 3.5F});
    above.right[3].types = {};
    const auto wider = joined(2, above, below, all);
    ASSERT_THAT(wider, SizeIs(1));
    EXPECT_EQ(wider[0].ends, (std::array{glm::vec2{3.5F, 2.5F}, glm::vec2{3.5F, 3.5F}}));
}

TEST(JoinCells, carriesLinesOverTheEdgeOfThePicture) {
    const CrossingRow above = crossedRight({{3, crossingAt({4.0F, 0.5F})}});
    const CrossingRow below = crossedRight({{3, crossingAt({4.0F, 1.5F})}});
    const auto pieces = joined(0, above, below, all);
    ASSERT_THAT(pieces, SizeIs(1));
    EXPECT_LT(pieces[0].ends[0].y, -16.0F) << "and half the widest stroke further";
    EXPECT_EQ(pieces[0].ends[1], glm::vec2(4.0F, 1.5F));
}

}  // namespace
}  // namespace inkedge::trace
