#include "cli/streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

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

}  // namespace

void holdStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        // The lowest number is taken, which is this one; the wrong way round, so that its use still fails with EBADF.
        (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

void print(std::string_view result) {
    if (const int error = writeAll(STDOUT_FILENO, result)) {
        throw Error{Error::Kind::Output,
                    fmt::format("stdout: expected it to take the result, found {}", explain(error))};
    }
}

void report(std::string_view label, std::string_view text) noexcept {
    try {
        (void)writeAll(STDERR_FILENO, fmt::format("inkedge: {}{}\n", label, base::printable(text)));
    } catch (...) {  // no memory to join the texts
        for (const std::string_view part : {std::string_view{"inkedge: "}, label, text, std::string_view{"\n"}}) {
            (void)writeAll(STDERR_FILENO, part);
        }
    }
}

}  // namespace inkedge::cli
