#include "trace/join_pieces.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "lines/views.h"
#include "scenes.h"

namespace inkedge::trace {
namespace {

using testing::SizeIs;

constexpr Size size{400, 300};

TracedPiece piece(glm::vec2 from, glm::vec2 to, LineType type = LineType::Crease, std::uint32_t triangle = 0) {
    return {{from, to}, {0.25F, 0.2F}, type, {0, triangle}};
}

class JoinPieces : public testing::Test {
protected:
    std::vector<Line> join(const std::vector<TracedPiece>& pieces) { return joinPieces(pieces, scene_, screen_); }

    Scene scene_ = scenes::sceneOf(scenes::cube(2.0));
    lines::Screen screen_{lines::views::perspective({5, 4, 7}), scene_.bounds().centre, size};
};

TEST_F(JoinPieces, makesOneLineOfThoseThatShareTheirEnds) {
    const auto lines = join({piece({10, 10}, {20, 10}), piece({30, 15}, {20, 10}), piece({30, 15}, {40, 15})});
    ASSERT_THAT(lines, SizeIs(1));
    ASSERT_THAT(lines[0].points, SizeIs(4));
    EXPECT_FALSE(lines[0].closed);
    EXPECT_TRUE(lines[0].visible);
    EXPECT_EQ(lines[0].object, 1U);
    EXPECT_GE(lines[0].patch, 1U);
}

TEST_F(JoinPieces, closesALineThatMeetsItsStart) {
    const auto lines = join(
        {piece({10, 10}, {60, 10}), piece({60, 10}, {60, 60}), piece({60, 60}, {10, 60}), piece({10, 60}, {10, 10})});
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_TRUE(lines[0].closed);
    EXPECT_THAT(lines[0].points, SizeIs(4));
}

TEST_F(JoinPieces, partsLinesWhereTheTypeChanges) {
    const auto lines = join({piece({10, 10}, {20, 10}), piece({20, 10}, {30, 10}, LineType::Outline)});
    ASSERT_THAT(lines, SizeIs(2));
    EXPECT_NE(lines[0].type, lines[1].type);
}

TEST_F(JoinPieces, giveScrapsOfAnotherTypeTheTypeBesideThem) {
    const auto lines = join({piece({10, 10}, {20, 10}), piece({20, 10}, {21.5, 10}, LineType::Outline),
                             piece({21.5, 10}, {30, 10}), piece({30, 10}, {31, 10}, LineType::Occlusion)});
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_EQ(lines[0].type, LineType::Crease);
    EXPECT_THAT(lines[0].points, SizeIs(5));
    // A scrap between two types goes to the longer line.
    const auto unlike = join({piece({10, 10}, {20, 10}), piece({20, 10}, {21, 10}, LineType::Boundary),
                              piece({21, 10}, {40, 10}, LineType::Outline)});
    ASSERT_THAT(unlike, SizeIs(2));
    EXPECT_EQ(unlike[1].points.front().pixel, glm::dvec2(20, 10));
    EXPECT_EQ(unlike[1].type, LineType::Outline);
}

TEST_F(JoinPieces, leaveOutStubs) {
    const std::vector<TracedPiece> through{piece({10, 10}, {20, 10}), piece({20, 10}, {30, 10})};
    const auto with = [&](glm::vec2 from, glm::vec2 to) {
        std::vector<TracedPiece> pieces = through;
        pieces.push_back(piece(from, to));
        return join(pieces);
    };
    EXPECT_THAT(with({20, 10}, {20, 11.5}), SizeIs(1));
    EXPECT_THAT(with({20, 10}, {20, 12.5}), SizeIs(2));
    EXPECT_THAT(with({22, 12}, {22, 13.5}), SizeIs(2)) << "it stands alone";
}

TEST_F(JoinPieces, knowsThePointsInTheWorld) {
    const auto lines = join({piece({10, 10}, {210, 110})});
    ASSERT_THAT(lines, SizeIs(1));
    const std::array depths{4.0, 5.0};
    for (std::size_t k = 0; k < 2; ++k) {
        const glm::dvec3 point = lines[0].points[k].position - scene_.bounds().centre;
        EXPECT_NEAR(screen_.depth(point), depths[k], 1e-6);
        EXPECT_LT(glm::distance(screen_.project(point).pixel, lines[0].points[k].pixel), 1e-9);
    }
}

}  // namespace
}  // namespace inkedge::trace
