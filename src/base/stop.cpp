#include "base/stop.h"

#include <chrono>
#include <utility>

#include <inkedge/error.h>

namespace inkedge::base {
namespace {

thread_local const StopScope* innermost = nullptr;

}  // namespace

StopScope::StopScope(std::function<bool()> stopRequested)
    : stopRequested_{std::move(stopRequested)}, around_{innermost}, before_{innermost} {
    innermost = this;
}

StopScope::StopScope(const StopScope* around) : around_{around}, before_{innermost} { innermost = this; }

StopScope::~StopScope() { innermost = before_; }

const StopScope* StopScope::current() noexcept { return innermost; }

void stopIfAsked() {
    for (const StopScope* scope = innermost; scope != nullptr; scope = scope->around_) {
        if (scope->stopRequested_ && scope->stopRequested_())
            throw Error{Error::Kind::Stopped, "expected to come to the end, found a request to stop; start it again"};
    }
}

std::unique_lock<std::timed_mutex> lockUnlessStopped(std::timed_mutex& mutex) {
    constexpr std::chrono::milliseconds betweenLooks{5};
    std::unique_lock lock{mutex, std::defer_lock};
    while (!lock.try_lock_for(betweenLooks)) stopIfAsked();
    return lock;
}

}  // namespace inkedge::base
