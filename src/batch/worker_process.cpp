#include "batch/worker_process.h"

#include <signal.h>

#include <span>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "process/memory.h"

namespace inkedge::batch {
namespace {

constexpr std::chrono::duration<double> forEver{1e9};  // items have limits of their own

std::span<const std::uint8_t> bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

WorkerProcess::WorkerProcess(const std::filesystem::path& program, const std::string& text, const WorkerLimits& limits)
    : limits_{limits}, child_{program, {std::string{workerVerb}}, bytesOf(text), forEver, [this] { look(); }} {}

void WorkerProcess::look() {
    constexpr std::chrono::milliseconds betweenLooks{50};
    const Clock::time_point now = Clock::now();
    if (limits_.stop) throw Error{Error::Kind::Stopped, "expected to come to the end, found a request to stop"};
    if (std::chrono::duration<double>(now - begin_).count() > limits_.seconds)
        throw NoAnswer{State::Timeout,
                       fmt::format("expected it to be drawn within {} s, found it still at work; raise --timeout",
                                   limits_.seconds)};
    if (now - looked_ < betweenLooks) return;
    looked_ = now;
    if (const std::uint64_t held = process::heldMemory(child_.process()); held > limits_.memory)
        throw NoAnswer{State::Memory, fmt::format("expected at most {} MB of memory, found {} MB; raise --max-memory",
                                                  limits_.memory / 1'000'000, held / 1'000'000)};
}

template <class Action>
auto WorkerProcess::asked(Action action) -> decltype(action()) {
    try {
        return action();
    } catch (const process::ProgramEnded& ended) {
        const bool killed = ended.signal() == SIGKILL || ended.signal() == SIGTERM || ended.signal() == SIGINT;
        if (killed)
            throw NoAnswer{State::Killed, "expected it to be drawn, found its worker killed, as when memory runs out"};
        throw NoAnswer{State::Crashed, fmt::format("expected it to be drawn, {}", ended.what())};
    }
}

void WorkerProcess::send(const Item& item) {
    if (sent_++ == answers_) begin_ = Clock::now();
    asked([&] { child_.send(bytesOf(lineOf(item))); });
}

Answer WorkerProcess::receive() {
    Answer answer = unpacked(asked([&] { return child_.receive(); }));
    ++answers_;
    begin_ = Clock::now();
    return answer;
}

}  // namespace inkedge::batch
