#include "base/thread_trial.h"

#include <latch>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace inkedge::base {

std::size_t startableThreads(std::size_t wanted) {
    std::latch end{1};  // until all are there
    std::vector<std::jthread> threads;
    threads.reserve(wanted);
    try {
        while (threads.size() < wanted) threads.emplace_back([&end] { end.wait(); });
    } catch (const std::system_error&) {  // the process may have no more threads
    } catch (const std::bad_alloc&) {
    }
    end.count_down();
    return threads.size();
}

}  // namespace inkedge::base
