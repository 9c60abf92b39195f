#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

#include "base/stop.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace inkedge::base {
namespace {

constexpr std::size_t maxThreads = 8;  // with more, memory is the limit

std::size_t threadsFor(std::size_t count) {
    if (count < 2 * elementsWorthAThread) return 1;
    return std::clamp<std::size_t>(count / elementsWorthAThread, 1, std::min(usableCores(), maxThreads));
}

}  // namespace

std::size_t usableCores() {
#ifdef __linux__
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return static_cast<std::size_t>(CPU_COUNT(&allowed));
#endif
    return std::max(1U, std::thread::hardware_concurrency());
}

void inRanges(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& work) {
    const std::size_t threads = threadsFor(count);
    stopIfAsked();
    if (threads == 1) return work(0, count);
    const StopScope* const around = StopScope::current();
    std::vector<std::exception_ptr> failures(threads);
    const auto run = [&](std::size_t i) noexcept {
        try {
            const StopScope scope{around};
            stopIfAsked();
            work(count * i / threads, count * (i + 1) / threads);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        others.reserve(threads - 1);
        for (std::size_t i = 1; i < threads; ++i) {
            try {
                others.emplace_back(run, i);
            } catch (const std::system_error&) {  // the process may have no more threads
                run(i);
            }
        }
        run(0);
    }
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

void onEach(std::size_t count, const std::function<void(std::size_t i)>& work) {
    constexpr std::size_t piecesWorthAThread = 8;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::atomic_flag failed;
    const StopScope* const around = StopScope::current();
    const auto run = [&] {
        try {
            const StopScope scope{around};
            for (std::size_t i = next++; i < count; i = next++) {
                stopIfAsked();
                work(i);
            }
        } catch (...) {
            if (!failed.test_and_set()) failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> others;
        const std::size_t wanted = std::min(usableCores(), count / piecesWorthAThread + 1);
        others.reserve(wanted);
        try {
            while (others.size() + 1 < wanted) others.emplace_back(run);
        } catch (const std::system_error&) {  // the process may have no more threads
        }
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace inkedge::base
