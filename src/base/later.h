#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <optional>
#include <system_error>
#include <utility>

#include "base/parallel.h"
#include "base/stop.h"

namespace inkedge::base {

/// A result that is worked out beside what this thread goes on with, until it is asked for. All that the work refers to
/// must outlive this, which waits for it when it ends.
template <class Result>
class Later {
public:
    /// @param elements  that are worked on: on a thread of its own if they are worth one, else when it is asked for
    Later(std::function<Result()> work, std::size_t elements) {
        auto run = [work = std::move(work), around = StopScope::current()] {
            const StopScope scope{around};
            return work();
        };
        try {
            if (elements >= elementsWorthAThread) coming_ = std::async(std::launch::async, run);
        } catch (const std::system_error&) {  // the process may have no more threads
        }
        if (!coming_.valid()) coming_ = std::async(std::launch::deferred, std::move(run));
    }

    /// @throws  what the work throws, at the first call
    [[nodiscard]] const Result& get() {
        if (!result_) result_.emplace(coming_.get());
        return *result_;
    }
    /// To be called once, instead of get().
    [[nodiscard]] Result take() { return coming_.get(); }

private:
    std::future<Result> coming_;
    std::optional<Result> result_;
};

}  // namespace inkedge::base
