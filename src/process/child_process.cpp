#include "process/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::process {
namespace {

constexpr int workThrew = 1;

[[noreturn]] void answer(const std::function<std::string()>& work, int writeEnd) noexcept {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int end : {SIGHUP, SIGINT, SIGTERM, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) ::signal(end, SIG_DFL);
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    try {
        const std::string text = work();
        for (std::string_view rest = text; !rest.empty();) {
            const ssize_t written = ::write(writeEnd, rest.data(), rest.size());
            if (written < 0 && errno != EINTR) ::_exit(workThrew);
            if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
        }
    } catch (...) {
        ::_exit(workThrew);
    }
    ::_exit(0);  // nothing of the parent's is flushed or ended twice
}

/// @return whether the other end was closed before the time was over
bool readToEnd(int readEnd, std::chrono::seconds limit, std::string& text) {
    const auto end = std::chrono::steady_clock::now() + limit;
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
        pollfd waiting{readEnd, POLLIN, 0};
        const int ready = left <= 0 ? 0 : ::poll(&waiting, 1, static_cast<int>(left));
        if (ready == 0) return false;
        std::array<char, 4096> bytes;
        const ssize_t count = ready < 0 ? -1 : ::read(readEnd, bytes.data(), bytes.size());
        if (count == 0 || (count < 0 && errno != EINTR)) return true;
        if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

Answer answerOfChild(const std::function<std::string()>& work, std::chrono::seconds limit) {
    std::array<int, 2> ends{};
    const bool connected = ::pipe2(ends.data(), O_CLOEXEC) == 0;
    const pid_t child = connected ? ::fork() : -1;
    if (child < 0) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("expected a process for a trial, found none: {}; end others first",
                                std::generic_category().message(errno))};
    }
    if (child == 0) answer(work, ends[1]);
    ::close(ends[1]);
    Answer result;
    const bool inTime = readToEnd(ends[0], limit, result.text);
    ::close(ends[0]);
    if (!inTime) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!inTime) {
        result.failure = fmt::format("found it still going after {} s", limit.count());
    } else if (WIFSIGNALED(status)) {
        result.failure = fmt::format("found a crash ({})", ::strsignal(WTERMSIG(status)));
    } else if (WEXITSTATUS(status) != 0) {
        result.failure = fmt::format("found exit status {}", WEXITSTATUS(status));
    }
    return result;
}

}  // namespace inkedge::process
