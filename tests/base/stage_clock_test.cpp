#include "base/stage_clock.h"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>

namespace inkedge::base {
namespace {

using testing::ElementsAre;
using testing::Field;

TEST(StageClock, givesEachStageTheTimeSinceTheOneBefore) {
    std::vector<StageTime> times;
    const Stopwatch all;
    StageClock clock{times};
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    clock.finish("slow");
    clock.finish("quick");
    ASSERT_THAT(times, ElementsAre(Field(&StageTime::stage, "slow"), Field(&StageTime::stage, "quick")));
    EXPECT_GE(times[0].milliseconds, 20.0);
    EXPECT_LE(times[0].milliseconds + times[1].milliseconds, all.milliseconds());
}

TEST(StageClock, addsUpAStageThatComesAgain) {
    std::vector<StageTime> times{{"again", 1000.0}};
    StageClock clock{times};
    clock.finish("between");
    clock.finish("again");
    ASSERT_THAT(times, ElementsAre(Field(&StageTime::stage, "again"), Field(&StageTime::stage, "between")));
    EXPECT_GT(times[0].milliseconds, 1000.0);
}

TEST(Stopwatch, runsFromWhenItWasMade) {
    const Stopwatch watch;
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
    const double first = watch.milliseconds();
    EXPECT_GE(first, 5.0);
    EXPECT_GE(watch.milliseconds(), first);
}

}  // namespace
}  // namespace inkedge::base
