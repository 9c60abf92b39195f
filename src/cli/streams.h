#pragma once

#include <string_view>

namespace inkedge::cli {

/// Opens those of stdin, stdout and stderr that the caller closed, so that no file of ours gets their numbers, and
/// messages are not written to it. Writing to a stream opened here fails.
void holdStandardStreams();

/// Writes to stdout at once. @throws Error  (Kind::Output) if stdout is closed, full or no longer read
void print(std::string_view result);

/// Writes "inkedge: ", both texts and a line's end to stderr; nothing happens if stderr is closed or full.
void report(std::string_view label, std::string_view text) noexcept;

}  // namespace inkedge::cli
