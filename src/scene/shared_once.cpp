#include "scene/shared_once.h"

#include "base/stop.h"

namespace inkedge::scene {

std::shared_ptr<const void> SharedOnce::get(const std::function<std::shared_ptr<const void>()>& make) {
    const std::unique_lock lock = base::lockUnlessStopped(mutex_);
    std::shared_ptr<const void> made = made_.lock();
    if (!made) {
        made = make();
        made_ = made;
    }
    return made;
}

long SharedOnce::holders() const {
    const std::scoped_lock lock{mutex_};
    return made_.use_count();
}

}  // namespace inkedge::scene
