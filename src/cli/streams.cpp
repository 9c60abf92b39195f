#include "cli/streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/message.h"

namespace inkedge::cli {
namespace {

/// @return 0, or the system's error number
int writeAll(int descriptor, std::string_view text) noexcept {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written > 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (written < 0 && errno == EAGAIN) {  // a pipe that its other end has set not to wait
            pollfd room{descriptor, POLLOUT, 0};
            ::poll(&room, 1, -1);
        } else if (written < 0 && errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

std::string explain(int error) {
    switch (error) {
        case EBADF:
            return "it closed; redirect it to a file or a pipe";
        case EPIPE:
            return "a pipe that nobody reads any more; read it to its end";
        default:
            return fmt::format("{}; redirect it to another place", std::generic_category().message(error));
    }
}

// Goes to the start of a terminal's line and clears it (ECMA-48).
constexpr std::string_view takeBack = "\r\x1b[K";

struct Status {
    std::mutex mutex;
    bool shown = false;
};
Status status;

}  // namespace

void holdStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        // The lowest number is taken, which is this one; the wrong way round, so that its use still fails with EBADF.
        (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

std::vector<std::uint8_t> readStandardInput(std::uint64_t maxBytes) {
    const auto refuse = [](const std::string& found) {
        throw Error{Error::Kind::Input, fmt::format("stdin: expected a model, found {}", found)};
    };
    if (::isatty(STDIN_FILENO) != 0) refuse("a terminal; redirect a file or a pipe to it");
    constexpr std::size_t step = 1 << 20;
    std::vector<std::uint8_t> bytes;
    for (std::size_t size = 0;;) {
        bytes.resize(size + step);
        const ssize_t found = ::read(STDIN_FILENO, bytes.data() + size, step);
        if (found < 0 && errno == EINTR) continue;
        if (found < 0) refuse(explain(errno));
        size += static_cast<std::size_t>(found);
        bytes.resize(size);
        if (size > maxBytes) refuse(fmt::format("more than {} bytes; raise --max-file-size", maxBytes));
        if (found == 0) return bytes;
    }
}

void print(std::string_view result) {
    if (const int error = writeAll(STDOUT_FILENO, result)) {
        throw Error{Error::Kind::Output,
                    fmt::format("stdout: expected it to take the result, found {}", explain(error))};
    }
}

bool showsStatus() noexcept {
    const char* const terminal = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view{terminal} != "dumb";
}

void showStatus(std::string_view text) noexcept {
    const std::scoped_lock lock{status.mutex};
    if (text.empty() && !status.shown) return;
    status.shown = !text.empty();
    try {
        (void)writeAll(STDERR_FILENO, fmt::format("{}{}", takeBack, base::printable(text)));
    } catch (...) {  // no memory for a line that need not be there
    }
}

void report(std::string_view label, std::string_view text) noexcept {
    const std::scoped_lock lock{status.mutex};
    try {
        const std::string_view before = std::exchange(status.shown, false) ? takeBack : "";
        (void)writeAll(STDERR_FILENO, fmt::format("{}inkedge: {}{}\n", before, label, base::printable(text)));
    } catch (...) {  // no memory to join the texts
        for (const std::string_view part : {std::string_view{"inkedge: "}, label, text, std::string_view{"\n"}}) {
            (void)writeAll(STDERR_FILENO, part);
        }
    }
}

}  // namespace inkedge::cli
