#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>

namespace inkedge::cli {

/// Says on stderr how far the work is once it takes over a second, in one line that the next message replaces. Says
/// nothing where stderr is no terminal.
class Progress {
public:
    /// @param reading  what is read first: the name of a model
    /// @param wanted   whether to say anything
    Progress(std::string reading, std::size_t views, bool wanted);

    void modelRead() noexcept { read_ = true; }
    void viewEnded() noexcept { ++ended_; }

private:
    [[nodiscard]] std::string text() const;

    std::string reading_;
    std::size_t views_;
    std::atomic<bool> read_ = false;
    std::atomic<std::size_t> ended_ = 0;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::jthread speaker_;
};

}  // namespace inkedge::cli
