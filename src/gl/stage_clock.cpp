#include "gl/stage_clock.h"

#include <fmt/format.h>

#include "gl/errors.h"

namespace inkedge::gl {

void StageClock::finish(const char* stage) {
    if (api_ != nullptr) {
        api_->Finish();
        checkErrors(*api_, fmt::format("the stage {}", stage), "ask for a smaller --size or --supersampling");
    }
    clock_.finish(stage);
}

}  // namespace inkedge::gl
