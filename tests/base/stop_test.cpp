// Work that is asked to stop, on this thread and on those that it starts.
#include "base/stop.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/expect_error.h"
#include "base/parallel.h"
#include "base/stage_clock.h"

namespace inkedge::base {
namespace {

constexpr auto stopped = Error::Kind::Stopped;
const auto anyText = testing::HasSubstr("expected to come to the end, found a request to stop");

TEST(StopScope, asksUntilItEnds) {
    bool asked = false;
    {
        const StopScope scope{[&] { return asked; }};
        EXPECT_NO_THROW(stopIfAsked());
        asked = true;
        expectError(stopped, anyText, [] { stopIfAsked(); });
    }
    EXPECT_NO_THROW(stopIfAsked());
    EXPECT_EQ(StopScope::current(), nullptr);
}

TEST(StopScope, asksThoseAroundIt) {
    const StopScope outer{[] { return true; }};
    const StopScope inner{[] { return false; }};
    expectError(stopped, anyText, [] { stopIfAsked(); });
}

TEST(StopScope, isThisThreadsOwn) {
    const StopScope scope{[] { return true; }};
    std::jthread{[] { EXPECT_NO_THROW(stopIfAsked()); }}.join();
    std::jthread{[around = &scope] {
        const StopScope same{around};
        EXPECT_THROW(stopIfAsked(), Error);
    }}.join();
}

TEST(StopScope, isLookedAtBetweenPieces) {
    std::atomic<int> done = 0;
    const StopScope scope{[&] { return done >= 100; }};
    expectError(stopped, anyText, [&] { onEach(100'000, [&](std::size_t) { ++done; }); });
    EXPECT_GE(done, 100);
    EXPECT_LT(done, 100 + 64) << "a piece a thread may be under way";
}

TEST(StopScope, isLookedAtBeforeEachRange) {
    for (const std::size_t count : {std::size_t{10}, 4 * elementsWorthAThread}) {
        const StopScope scope{[] { return true; }};
        expectError(stopped, anyText, [&] {
            inRanges(count, [](std::size_t, std::size_t) { ADD_FAILURE() << "expected no range to be worked on"; });
        });
    }
}

TEST(StopScope, isKnownToTheThreadsOfRanges) {
    const StopScope scope{[] { return false; }};
    std::atomic<int> without = 0;
    inRanges(4 * elementsWorthAThread, [&](std::size_t, std::size_t) {
        if (StopScope::current() == nullptr) ++without;
    });
    onEach(1000, [&](std::size_t) {
        if (StopScope::current() == nullptr) ++without;
    });
    EXPECT_EQ(without, 0);
    EXPECT_EQ(StopScope::current(), &scope);
}

TEST(StopScope, isLookedAtWhenAStageEnds) {
    std::vector<StageTime> times;
    StageClock clock{times};
    const StopScope scope{[] { return true; }};
    expectError(stopped, anyText, [&] { clock.finish("stage"); });
    EXPECT_EQ(times.size(), 1U);
}

TEST(StopScope, ofNoneIsNotStopped) {
    const StopScope asked{[] { return true; }};
    EXPECT_THROW(stopIfAsked(), Error);
    {
        const StopScope toTheEnd{static_cast<const StopScope*>(nullptr)};
        EXPECT_NO_THROW(stopIfAsked());
    }
    EXPECT_THROW(stopIfAsked(), Error);
}

TEST(LockUnlessStopped, waitsUntilTheMutexIsFree) {
    std::timed_mutex mutex;
    std::unique_lock held{mutex};
    std::atomic<int> looks = 0;
    std::atomic<bool> locked = false;
    const std::jthread waiting{[&] {
        const StopScope scope{[&] {
            ++looks;
            return false;
        }};
        const std::unique_lock lock = lockUnlessStopped(mutex);
        locked = true;
    }};
    while (looks < 3) std::this_thread::yield();
    EXPECT_FALSE(locked);
    held.unlock();
    while (!locked) std::this_thread::yield();
}

TEST(LockUnlessStopped, givesUpWhenAskedTo) {
    std::timed_mutex mutex;
    const std::unique_lock other{mutex};
    std::jthread{[&] {
        const StopScope scope{[] { return true; }};
        EXPECT_THROW((void)lockUnlessStopped(mutex), Error);
    }}.join();
}

}  // namespace
}  // namespace inkedge::base
