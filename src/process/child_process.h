#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace inkedge::process {

/// What a child process found out.
struct Answer {
    std::string text;     ///< what the work returned
    std::string failure;  ///< why it did not come to its end: "found ..."; empty where it did
};

/// Does work in a process of its own, so that its crash or its endless wait is an answer too. No other thread may run.
/// @param limit   after which the work is ended
/// @throws Error  (Kind::Runtime) if the system gives no process
[[nodiscard]] Answer answerOfChild(const std::function<std::string()>& work, std::chrono::seconds limit);

}  // namespace inkedge::process
