#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "batch/item.h"
#include "batch/reply.h"
#include "process/child_program.h"

namespace inkedge::batch {

/// What workers may take, and what ends them.
struct WorkerLimits {
    double seconds = 0.0;      ///< an item
    std::uint64_t memory = 0;  ///< bytes
    const std::atomic<bool>& stop;
};

/// Why no answer comes of a worker, which is not to be asked again.
class NoAnswer : public std::runtime_error {
public:
    /// @param message  "expected ..., found ..."
    NoAnswer(State state, const std::string& message) : std::runtime_error{message}, state_{state} {}
    [[nodiscard]] State state() const noexcept { return state_; }

private:
    State state_;
};

/// A worker process. It takes the next item while it draws the last one.
class WorkerProcess {
public:
    /// @param text     of the planner
    /// @throws Error   (Kind::Runtime) if it cannot be started
    WorkerProcess(const std::filesystem::path& program, const std::string& text, const WorkerLimits&);

    /// @throws NoAnswer  as receive()
    void send(const Item&);

    /// The answer for the item that was sent first of those without one.
    /// @throws NoAnswer  if the process ends, takes longer for the item than it may, or more memory
    /// @throws Error     (Kind::Stopped) if it is told to stop
    [[nodiscard]] Answer receive();

    /// Whether the item that it is at is its first.
    [[nodiscard]] bool isNew() const noexcept { return answers_ == 0; }

private:
    using Clock = std::chrono::steady_clock;

    void look();
    template <class Action>
    auto asked(Action action) -> decltype(action());

    WorkerLimits limits_;
    process::ChildProgram child_;
    Clock::time_point begin_ = Clock::now();  // of the item that it is at
    Clock::time_point looked_ = Clock::now();
    std::uint64_t sent_ = 0;
    std::uint64_t answers_ = 0;
};

}  // namespace inkedge::batch
