#pragma once

#include <chrono>
#include <string_view>
#include <vector>

#include <inkedge/stage_time.h>

namespace inkedge::base {

/// Wall time since it was made.
class Stopwatch {
public:
    [[nodiscard]] double milliseconds() const noexcept {
        return std::chrono::duration<double, std::milli>(Clock::now() - begin_).count();
    }

private:
    using Clock = std::chrono::steady_clock;  // never set back
    Clock::time_point begin_ = Clock::now();
};

/// Times stages that follow each other.
class StageClock {
public:
    /// @param times  must outlive the clock
    explicit StageClock(std::vector<StageTime>& times) : times_{times} {}

    /// Adds the time since the last stage ended to what this stage took before.
    /// @throws Error  (Kind::Stopped) as stopIfAsked() does
    void finish(std::string_view stage);

private:
    std::vector<StageTime>& times_;
    Stopwatch stage_;
};

}  // namespace inkedge::base
