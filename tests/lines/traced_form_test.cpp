#include "lines/find/traced_form.h"

#include <gmock/gmock.h>

namespace inkedge::lines {
namespace {

using testing::IsEmpty;

const FormFace face{7, {glm::dvec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {10, 11, 12}};

std::vector<FormSegment> through(const std::array<FormCorner, 3>& corners, double minStrength = 0.0) {
    std::vector<FormSegment> found;
    traceThrough(face, corners, minStrength, found);
    return found;
}

TEST(TraceThrough, findsWhereAValueIsZeroOnTwoEdges) {
    const auto found = through({{{-1.0, 2.0}, {3.0, 4.0}, {1.0, 6.0}}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].triangle, 7U);
    EXPECT_EQ(found[0].ends[0], glm::dvec3(1, 0, 0));
    EXPECT_EQ(found[0].ends[1], glm::dvec3(0, 2, 0));
    EXPECT_THAT(found[0].edges, testing::ElementsAre(10U, 12U));
    EXPECT_THAT(found[0].strengths, testing::ElementsAre(2.5, 4.0));
}

TEST(TraceThrough, findsNothingWhereAllValuesHaveOneSign) {
    EXPECT_THAT(through({{{1.0, 1.0}, {3.0, 1.0}, {1.0, 1.0}}}), IsEmpty());
    EXPECT_THAT(through({{{-1.0, 1.0}, {-3.0, 1.0}, {0.0, 1.0}}}), IsEmpty()) << "0 counts as below";
}

TEST(TraceThrough, endsWhereALineIsTooWeakOrTurnsAway) {
    const auto weak = through({{{-1.0, 2.0}, {3.0, 4.0}, {1.0, 6.0}}}, 3.25);
    ASSERT_EQ(weak.size(), 1U);
    EXPECT_EQ(weak[0].ends[0], glm::dvec3(0.5, 1, 0)) << "half-way from 2.5 to 4";
    EXPECT_EQ(weak[0].edges[0], mesh::noHalfEdge);
    EXPECT_EQ(weak[0].strengths[0], 3.25);
    EXPECT_EQ(weak[0].edges[1], 12U);
    EXPECT_THAT(through({{{-1.0, 2.0}, {3.0, 4.0}, {1.0, 6.0}}}, 4.5), IsEmpty());
    const auto turned = through({{{-1.0, 2.0, 1.0}, {1.0, 2.0, -3.0}, {1.0, 2.0, 1.0}}});
    ASSERT_EQ(turned.size(), 1U);
    EXPECT_EQ(turned[0].ends[0], glm::dvec3(1, 1, 0)) << "half-way from -1 to 1";
    EXPECT_THAT(through({{{-1.0, 2.0, -1.0}, {1.0, 2.0, -1.0}, {1.0, 2.0, -1.0}}}), IsEmpty());
}

// Segments of length 1 along x, joined end to end.
std::vector<FormSegment> row(const std::vector<double>& strengths, std::uint32_t firstEdge) {
    std::vector<FormSegment> segments;
    for (std::size_t i = 0; i + 1 < strengths.size(); ++i) {
        const auto edge = firstEdge + static_cast<std::uint32_t>(i);
        const auto x = static_cast<double>(i);
        segments.push_back(
            {0, {glm::dvec3{x, 0, 0}, {x + 1, 0, 0}}, {edge, edge + 1}, {strengths[i], strengths[i + 1]}});
    }
    return segments;
}

TEST(StrongLines, areThoseThatAreStrongSomewhereAndLongEnough) {
    mesh::MeshTopology topology;
    topology.patches = {0};
    const std::array minLengths{2.5};
    EXPECT_EQ(strongLines(row({1, 1, 3, 1}, 0), 2.0, minLengths, topology).size(), 3U) << "weak parts carry it on";
    EXPECT_THAT(strongLines(row({1, 1, 1, 1}, 0), 2.0, minLengths, topology), IsEmpty());
    EXPECT_THAT(strongLines(row({3, 3, 3}, 0), 2.0, minLengths, topology), IsEmpty()) << "two long";
    std::vector<FormSegment> two = row({1, 3, 1, 1}, 0);
    const std::vector<FormSegment> weak = row({1, 1, 1, 1, 1}, 20);
    two.insert(two.end(), weak.begin(), weak.end());
    EXPECT_EQ(strongLines(two, 2.0, minLengths, topology).size(), 3U) << "a strong line keeps no other";
}

}  // namespace
}  // namespace inkedge::lines
