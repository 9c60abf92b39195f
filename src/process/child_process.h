#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace inkedge::process {

/// The outcome of a child process.
struct Answer {
    std::string text;     ///< what the work returned
    std::string failure;  ///< why the work did not end: "found ..."; empty if it did
};

/// Does work in a process of its own, so that a crash or an endless wait is an answer too. No other thread may run.
/// @param limit   the process is killed after this time
/// @throws Error  (Kind::Runtime) if no process can be started
[[nodiscard]] Answer answerOfChild(const std::function<std::string()>& work, std::chrono::seconds limit);

}  // namespace inkedge::process
