#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace inkedge::cli {

/// Opens those of stdin, stdout and stderr that the caller closed, so that no file of ours gets their numbers, and
/// messages are not written to it. Writing to a stream opened here fails.
void holdStandardStreams();

/// Reads stdin to its end.
/// @throws Error  (Kind::Input) if it is a terminal, cannot be read or has more bytes
[[nodiscard]] std::vector<std::uint8_t> readStandardInput(std::uint64_t maxBytes);

/// Writes to stdout at once. @throws Error  (Kind::Output) if stdout is closed, full or no longer read
void print(std::string_view result);

/// Whether stderr is a terminal that can take back a line.
[[nodiscard]] bool showsStatus() noexcept;

/// Shows a line on such a terminal in the place of the last one. The next report() takes it back, an empty text too.
void showStatus(std::string_view text) noexcept;

/// Writes "inkedge: ", both texts and a line's end to stderr; nothing happens if stderr is closed or full.
void report(std::string_view label, std::string_view text) noexcept;

}  // namespace inkedge::cli
