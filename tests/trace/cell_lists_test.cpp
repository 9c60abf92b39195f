#include "trace/cell_lists.h"

#include <algorithm>
#include <cstdlib>
#include <random>

#include <gmock/gmock.h>

namespace inkedge::trace {
namespace {

std::vector<std::uint32_t> around(const CellLists& lists, Cell cell) {
    std::vector<std::uint32_t> found;
    lists.anyAround(cell, [&](std::uint32_t i) {
        found.push_back(i);
        return false;
    });
    return found;
}

TEST(CellLists, countsCellsFromTheTopLeftOne) {
    EXPECT_EQ(cellOf({0.0, 3.9}, 0.5), (Cell{0, 1}));
    EXPECT_EQ(cellOf({-0.1, -2.0}, 0.5), (Cell{-1, -1}));
    EXPECT_EQ(cellOf({-2.1, 2.0}, 0.5), (Cell{-2, 1}));
}

TEST(CellLists, findThePointsOfTheCellsAround) {
    std::mt19937 random{7};
    std::vector<Cell> cells;
    CellLists lists;
    for (int i = 0; i < 5000; ++i) {  // more than there are buckets at first
        cells.push_back({static_cast<int>(random() % 60) - 30, static_cast<int>(random() % 60) - 30});
        lists.add(cells.back());
    }
    for (int y = -32; y < 32; ++y) {
        for (int x = -32; x < 32; ++x) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < cells.size(); ++i)
                if (std::abs(cells[i].x - x) <= 1 && std::abs(cells[i].y - y) <= 1) expected.push_back(i);
            std::vector<std::uint32_t> found = around(lists, {x, y});
            std::ranges::sort(found);
            ASSERT_EQ(found, expected) << x << ", " << y;
        }
    }
}

TEST(CellLists, keepTheOrderAndStopWhenAsked) {
    CellLists lists;
    for (int i = 0; i < 3000; ++i) lists.add({i % 2, 4});
    std::vector<std::uint32_t> found;
    EXPECT_TRUE(lists.anyIn({1, 4}, [&](std::uint32_t i) {
        found.push_back(i);
        return found.size() == 3;
    }));
    EXPECT_THAT(found, testing::ElementsAre(1, 3, 5));
    EXPECT_FALSE(lists.anyIn({2, 4}, [](std::uint32_t) { return true; }));
}

}  // namespace
}  // namespace inkedge::trace
