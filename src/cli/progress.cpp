#include "cli/progress.h"

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/streams.h"

namespace inkedge::cli {

using namespace std::chrono_literals;

Progress::Progress(std::string reading, std::size_t views, bool wanted) : reading_{std::move(reading)}, views_{views} {
    if (!wanted || !showsStatus()) return;
    const auto speak = [this](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any waiting;
        std::unique_lock lock{mutex};
        const auto ended = [&](std::chrono::milliseconds time) {
            return waiting.wait_for(lock, stop, time, [&] { return stop.stop_requested(); });
        };
        for (bool stopped = ended(1s); !stopped; stopped = ended(200ms)) showStatus(text());
        showStatus({});
    };
    try {
        speaker_ = std::jthread{speak};
    } catch (const std::system_error&) {  // the process may have no more threads
    }
}

std::string Progress::text() const {
    const auto seconds = std::chrono::duration<double>{std::chrono::steady_clock::now() - begin_}.count();
    const std::size_t ended = ended_;
    if (!read_) return fmt::format("reading {}, {:.0f} s", reading_, seconds);
    if (views_ == 1) return fmt::format("drawing {}, {:.0f} s", reading_, seconds);
    if (ended == 0 || ended >= views_) return fmt::format("{} of {} views, {:.0f} s", ended, views_, seconds);
    const double left = seconds / static_cast<double>(ended) * static_cast<double>(views_ - ended);
    return fmt::format("{} of {} views, {:.0f} s left", ended, views_, left);
}

}  // namespace inkedge::cli
