#include "scene/box_tree.h"

#include <set>
#include <vector>

#include <gmock/gmock.h>

namespace inkedge::scene {
namespace {

std::vector<Box> manyBoxes(std::size_t count) {
    std::vector<Box> boxes;
    std::uint32_t state = 1;
    const auto next = [&] {
        state = state * 1664525U + 1013904223U;
        return static_cast<double>(state >> 16U) / 65536.0;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 low{next(), next(), next()};
        boxes.push_back({low, low + 0.2 * glm::dvec3{next(), next(), next()}});
    }
    return boxes;
}

bool overlap(const Box& a, const Box& b) {
    for (int i = 0; i < 3; ++i)
        if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
    return true;
}

TEST(BoxTree, findsEveryBoxThatOverlapsAndNoOther) {
    for (const std::size_t count : {0U, 1U, 8U, 9U, 16U, 17U, 500U}) {
        const std::vector<Box> boxes = manyBoxes(count);
        const BoxTree tree{boxes};
        for (const Box& box : boxes) {
            std::set<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < count; ++i)
                if (overlap(boxes[i], box)) expected.insert(i);
            std::set<std::uint32_t> found;
            std::uint64_t steps = 1'000'000;
            tree.forEachOverlap(box, steps, [&](std::uint32_t i, const Box&) { EXPECT_TRUE(found.insert(i).second); });
            EXPECT_EQ(found, expected) << count;
        }
    }
}

TEST(BoxTree, endsWhenNoStepsAreLeft) {
    const std::vector<Box> boxes(1000, Box{glm::dvec3{0.0}, glm::dvec3{1.0}});
    const BoxTree tree{boxes};
    std::uint64_t steps = 100;
    std::size_t found = 0;
    tree.forEachOverlap(boxes[0], steps, [&](std::uint32_t, const Box&) { ++found; });
    EXPECT_EQ(steps, 0U);
    EXPECT_GT(found, 50U);
    EXPECT_LE(found, 100U);
}

}  // namespace
}  // namespace inkedge::scene
