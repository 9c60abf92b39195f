#pragma once

#include <vector>

#include "base/stage_clock.h"
#include "gl/api.h"

namespace inkedge::gl {

/// Times the stages of a render and stops at the first that left a GL error.
class StageClock {
public:
    StageClock(const Api& api, std::vector<StageTime>& times) : api_{&api}, clock_{times} {}
    /// For stages that draw nothing.
    explicit StageClock(std::vector<StageTime>& times) : api_{nullptr}, clock_{times} {}

    /// Waits until the stage's work is done, and adds the time since the last stage to this stage's.
    /// @throws Error  (Kind::Runtime) if OpenGL reports an error or a lost context; (Kind::Stopped) as stopIfAsked()
    ///                does
    void finish(const char* stage);

private:
    const Api* api_;  // null: there is no OpenGL work to wait for
    inkedge::base::StageClock clock_;
};

}  // namespace inkedge::gl
