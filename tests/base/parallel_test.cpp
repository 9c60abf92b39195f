#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <sched.h>

#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::base {
namespace {

TEST(InRanges, coversEverythingOnce) {
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{1}, 2 * elementsWorthAThread + 1, 10 * elementsWorthAThread}) {
        std::vector<int> visits(count, 0);
        inRanges(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        EXPECT_TRUE(std::ranges::all_of(visits, [](int times) { return times == 1; })) << count;
    }
}

TEST(PartsOf, keepsTheOrderOfItsRanges) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, 10 * elementsWorthAThread}) {
        std::size_t reached = 0;
        for (const auto& [begin, end] : partsOf(count, [](std::size_t begin, std::size_t end) {
                 return std::pair{begin, end};
             })) {
            EXPECT_EQ(begin, reached);
            reached = end;
        }
        EXPECT_EQ(reached, count);
    }
}

TEST(InRanges, staysOnOneThreadForLittle) {
    const auto caller = std::this_thread::get_id();
    int calls = 0;
    inRanges(2 * elementsWorthAThread - 1, [&](std::size_t, std::size_t) {
        ++calls;
        EXPECT_EQ(std::this_thread::get_id(), caller);
    });
    EXPECT_EQ(calls, 1);
}

TEST(InRanges, throwsWhatARangeHasThrown) {
    std::atomic<int> calls = 0;
    const auto fail = [&](std::size_t, std::size_t end) {
        ++calls;
        if (end == 8 * elementsWorthAThread) throw std::runtime_error{"the last"};
    };
    EXPECT_THROW(inRanges(8 * elementsWorthAThread, fail), std::runtime_error);
    EXPECT_GE(calls, 1);
}

// A long sheet of wavy steps, and a square in the plane of the first, which is flat.
Scene steppedSheet() {
    constexpr std::uint32_t length = 25'000;
    constexpr std::uint32_t width = 10;
    Mesh sheet;
    for (std::uint32_t x = 0; x < length; ++x)
        for (std::uint32_t y = 0; y < width; ++y)
            sheet.positions.emplace_back(x, y, x < 20 ? 0.0 : x / 20 % 2 * 20.0 + 0.2 * std::sin(0.7 * x + 1.3 * y));
    for (std::uint32_t x = 0; x + 1 < length; ++x)
        for (std::uint32_t y = 0; y + 1 < width; ++y) {
            const std::uint32_t i = x * width + y;
            sheet.indices.insert(sheet.indices.end(), {i, i + width, i + 1, i + 1, i + width, i + width + 1});
        }
    return scenes::sceneOf(
        {{sheet, glm::dmat4{1.0}}, {scenes::quad({5, 2, 0}, {9, 2, 0}, {9, 6, 0}, {5, 6, 0}), glm::dmat4{1.0}}});
}

// Keeps this thread on one core.
class OneCore {
public:
    OneCore() {
        sched_getaffinity(0, sizeof all_, &all_);
        int core = 0;
        while (!CPU_ISSET(static_cast<std::size_t>(core), &all_)) ++core;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<std::size_t>(core), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneCore() { sched_setaffinity(0, sizeof all_, &all_); }
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

private:
    cpu_set_t all_{};
};

// Those that take part in work that gives each of them time to begin.
std::size_t threadsOfPieces() {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    onEach(1000, [&](std::size_t) {
        std::this_thread::sleep_for(std::chrono::microseconds{100});
        const std::scoped_lock lock{mutex};
        threads.insert(std::this_thread::get_id());
    });
    return threads.size();
}

TEST(OnEach, usesTheCoresOfThisProcessOnly) {
    if (usableCores() < 2) GTEST_SKIP() << "one core only";
    EXPECT_GT(threadsOfPieces(), 1U);
    EXPECT_LE(threadsOfPieces(), usableCores());
    const OneCore core;
    EXPECT_EQ(usableCores(), 1U);
    EXPECT_EQ(threadsOfPieces(), 1U);
}

int threadsUsed() {
    std::atomic<int> calls = 0;
    inRanges(2 * elementsWorthAThread, [&](std::size_t, std::size_t) { ++calls; });
    return calls;
}

TEST(Scene, isPreparedAlikeByOneThreadAndByMany) {
    if (threadsUsed() < 2) GTEST_SKIP() << "one core only";
    const Scene many = steppedSheet();
    const Scene one = [] {
        const OneCore core;
        EXPECT_EQ(threadsUsed(), 1);
        return steppedSheet();
    }();
    const Mesh& mesh = many.meshes()[0];
    EXPECT_EQ(mesh.positions, one.meshes()[0].positions);
    EXPECT_EQ(mesh.normals, one.meshes()[0].normals);
    EXPECT_EQ(mesh.indices, one.meshes()[0].indices);
    EXPECT_EQ(scene::topologyOf(many, 0).points, scene::topologyOf(one, 0).points);
    EXPECT_EQ(scene::topologyOf(many, 0).twins, scene::topologyOf(one, 0).twins);
    EXPECT_EQ(scene::topologyOf(many, 0).originals, scene::topologyOf(one, 0).originals);
    EXPECT_EQ(scene::topologyOf(many, 0).creases, scene::topologyOf(one, 0).creases);
    EXPECT_EQ(scene::topologyOf(many, 0).patches, scene::topologyOf(one, 0).patches);
    EXPECT_EQ(scene::patchNumbersOf(many).number, scene::patchNumbersOf(one).number);
    EXPECT_EQ(scene::patchNumbersOf(many).layered, scene::patchNumbersOf(one).layered);
    EXPECT_THAT(scene::patchNumbersOf(many).layered, testing::Contains(true));
    EXPECT_THAT(scene::patchNumbersOf(many).layered, testing::Contains(false));
    EXPECT_THAT(scene::topologyOf(many, 0).creases, testing::Contains(true));
}

}  // namespace
}  // namespace inkedge::base
