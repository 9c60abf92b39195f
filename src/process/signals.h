#pragma once

#include <string>

namespace inkedge::process {

/// Makes sure that no signal leaves a temporary file behind. SIGHUP, SIGINT and SIGTERM, unless the caller ignores
/// them, end the process with 129, 130 and 143. A crash, say of a graphics driver, is reported in a line before it ends
/// the process. A pipe that nobody reads and a limit on the size of files become errors of write().
void handleSignals();

/// Ends the process with exit code 1 and this line on stderr once so many seconds have passed, whatever it does then.
/// @param seconds  over 0, up to longestTimeout
void limitTime(double seconds, std::string line);

constexpr double longestTimeout = 1e8;  // three years

}  // namespace inkedge::process
