#include "base/later.h"

#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>

#include <inkedge/error.h>

namespace inkedge::base {
namespace {

constexpr std::size_t many = elementsWorthAThread;

TEST(Later, isWorkedOutOnceOnAThreadOfItsOwnIfThatIsWorthIt) {
    for (const std::size_t elements : {std::size_t{1}, many}) {
        int calls = 0;
        Later<std::thread::id> thread{[&] { return ++calls, std::this_thread::get_id(); }, elements};
        EXPECT_EQ(thread.get() == std::this_thread::get_id(), elements < many);
        (void)thread.get();
        EXPECT_EQ(calls, 1);
    }
}

TEST(Later, throwsWhatTheWorkThrowsWhenItIsAskedFor) {
    for (const std::size_t elements : {std::size_t{1}, many}) {
        Later<int> fails{[]() -> int { throw std::runtime_error{"fails"}; }, elements};
        EXPECT_THROW((void)fails.take(), std::runtime_error);
    }
}

TEST(Later, isWaitedForIfNobodyAsks) {
    bool done = false;
    {
        const Later<int> unasked{[&] { return done = true, 1; }, many};
    }
    EXPECT_TRUE(done);
}

TEST(Later, stopsWithTheScopeThatItWasBegunIn) {
    const StopScope stopped{[] { return true; }};
    for (const std::size_t elements : {std::size_t{1}, many}) {
        Later<int> stops{[] { return stopIfAsked(), 1; }, elements};
        EXPECT_THROW((void)stops.get(), Error);
    }
}

}  // namespace
}  // namespace inkedge::base
