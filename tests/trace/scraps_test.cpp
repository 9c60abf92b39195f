#include "trace/scraps.h"

#include <gmock/gmock.h>

namespace inkedge::trace {
namespace {

// Pieces of a line through points.
std::vector<TracedPiece> pieces(LineType type, const std::vector<glm::vec2>& pixels, std::uint32_t instance = 0) {
    std::vector<TracedPiece> found;
    for (std::size_t i = 1; i < pixels.size(); ++i)
        found.push_back({{pixels[i - 1], pixels[i]}, {1.0F, 1.0F}, type, {instance, 0}});
    return found;
}

std::size_t keptOf(const std::vector<std::vector<TracedPiece>>& lines) {
    std::vector<TracedPiece> all;
    for (const std::vector<TracedPiece>& line : lines) all.insert(all.end(), line.begin(), line.end());
    leaveOutScraps(all);
    return all.size();
}

const std::vector<TracedPiece> longCrease =
    pieces(LineType::Crease, {{0, 50}, {1, 50}, {2, 50.5}, {3, 50}, {4, 50}, {5, 50}});

TEST(TracedScraps, areShortLinesThatReachNoOther) {
    EXPECT_EQ(keptOf({longCrease}), 5U);
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Occlusion, {{5, 5}, {6, 5}, {7, 5.5}})}), 5U);
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Marked, {{5, 5}, {6, 5}, {7, 5.5}})}), 7U);
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Crease, {{5, 5}, {5.9F, 5}, {5.9F, 5.8F}, {5, 5}})}), 5U)
        << "closed";
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Crease, {{5, 5}, {5, 5}})}), 5U) << "a point";
}

TEST(TracedScraps, stayWhereTheyJoinAnotherLine) {
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Crease, {{2, 50.5}, {2, 51.5}})}), 6U);
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Crease, {{6.4F, 50}, {7, 50}})}), 6U) << "across a gap";
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Crease, {{6.6F, 50}, {7, 50}})}), 5U);
}

TEST(TracedScraps, areNotTheOutlinesOfTinyThings) {
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Outline, {{5, 5}, {6, 5}}, 1)}), 6U);
    EXPECT_EQ(keptOf({longCrease, pieces(LineType::Outline, {{5, 5}, {6, 5}}, 0)}), 5U) << "a hole, for one";
}

}  // namespace
}  // namespace inkedge::trace
