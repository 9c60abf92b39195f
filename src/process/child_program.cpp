#include "process/child_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

extern char** environ;

namespace inkedge::process {
namespace {

constexpr std::uint64_t maxMessage = std::uint64_t{1} << 40U;  // bytes

// Closed at its end; numbered above the descriptors that the program finds.
class Descriptor {
public:
    explicit Descriptor(int descriptor) {
        if (descriptor < 0) fail(errno);
        constexpr int above = 10;
        number_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, above);
        const int failure = errno;
        ::close(descriptor);
        if (number_ < 0) fail(failure);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }

    [[noreturn]] static void fail(int error) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("expected a process for reading the file, found none: {}; end others first",
                                std::generic_category().message(error))};
    }
    [[nodiscard]] int number() const noexcept { return number_; }
    [[nodiscard]] int release() noexcept { return std::exchange(number_, -1); }

private:
    int number_ = -1;
};

void writeAll(int descriptor, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) Descriptor::fail(errno);
        if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

struct Actions {
    Actions() { ::posix_spawn_file_actions_init(&all); }
    Actions(const Actions&) = delete;
    Actions& operator=(const Actions&) = delete;
    ~Actions() { ::posix_spawn_file_actions_destroy(&all); }
    posix_spawn_file_actions_t all{};
};

// No signal is blocked or ignored in the program, whatever this process does with it.
struct Attributes {
    Attributes() {
        sigset_t none;
        sigset_t every;
        ::sigemptyset(&none);
        ::sigfillset(&every);
        ::posix_spawnattr_init(&all);
        ::posix_spawnattr_setsigmask(&all, &none);
        ::posix_spawnattr_setsigdefault(&all, &every);
        ::posix_spawnattr_setflags(&all, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    ~Attributes() { ::posix_spawnattr_destroy(&all); }
    posix_spawnattr_t all{};
};

pid_t start(const std::filesystem::path& program, const std::vector<std::string>& arguments, int bytes, int socket) {
    Actions actions;
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&actions.all, stream, "/dev/null", O_RDWR, 0);
    ::posix_spawn_file_actions_adddup2(&actions.all, bytes, 3);
    ::posix_spawn_file_actions_adddup2(&actions.all, socket, 4);
    const Attributes attributes;
    std::string name = program.string();
    std::vector<std::string> texts = arguments;
    std::vector<char*> list{name.data()};
    for (std::string& text : texts) list.push_back(text.data());
    list.push_back(nullptr);
    pid_t child = -1;
    const int failure = ::posix_spawn(&child, name.c_str(), &actions.all, &attributes.all, list.data(), environ);
    if (failure != 0) Descriptor::fail(failure);
    return child;
}

}  // namespace

ChildProgram::ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           std::span<const std::uint8_t> bytes, std::chrono::duration<double> limit,
                           std::function<void()> waiting)
    : limit_{limit}, waiting_{std::move(waiting)} {
    const Descriptor file{::memfd_create("inkedge", MFD_CLOEXEC)};
    writeAll(file.number(), bytes);
    ::lseek(file.number(), 0, SEEK_SET);
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) Descriptor::fail(errno);
    Descriptor own{ends[0]};
    const Descriptor other{ends[1]};
    child_ = start(program, arguments, file.number(), other.number());
    socket_ = own.release();
}

ChildProgram::~ChildProgram() {
    ::close(socket_);
    if (child_ < 0) return;
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::chrono::duration<double> ChildProgram::processorTime() const {
    clockid_t clock{};
    timespec time{};
    if (::clock_getcpuclockid(child_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return {};
    return std::chrono::duration<double>{static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec)};
}

bool ChildProgram::sleeps() const {
    constexpr std::string_view awake = "RDTt";  // proc(5): runs or could, waits for a disk, is stopped
    std::error_code ended;
    std::filesystem::directory_iterator thread{fmt::format("/proc/{}/task", child_), ended};
    for (; !ended && thread != std::filesystem::directory_iterator{}; thread.increment(ended)) {
        std::ifstream file{thread->path() / "stat"};
        std::string text;
        std::getline(file, text);
        const std::size_t state = text.rfind(") ") + 2;  // after the program's name
        if (state < text.size() && awake.find(text[state]) != std::string_view::npos) return false;
    }
    return true;
}

void ChildProgram::waitFor(short event) {
    constexpr std::chrono::milliseconds slice{20};
    pollfd ready{socket_, event, 0};
    while (true) {
        waiting_();
        const auto before = processorTime();
        if (::poll(&ready, 1, static_cast<int>(slice.count())) > 0) return;
        const auto used = processorTime();
        if (used == before && sleeps()) slept_ += slice;
        if (used + slept_ > limit_)
            throw Error{Error::Kind::Input, fmt::format("found it still at work after {:.4g} s", limit_.count())};
    }
}

void ChildProgram::refuseEnd() {
    constexpr int maxTries = 100;  // of 10 ms: it may still be ending
    int status = 0;
    for (int i = 0; ::waitpid(child_, &status, WNOHANG) == 0; ++i) {
        if (i == maxTries) ::kill(child_, SIGKILL);
        ::usleep(10'000);
    }
    child_ = -1;
    const std::string found = WIFSIGNALED(status) ? fmt::format("a crash ({})", ::strsignal(WTERMSIG(status)))
                                                  : fmt::format("exit status {}", WEXITSTATUS(status));
    throw ProgramEnded{"found " + found, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

void ChildProgram::send(std::span<const std::uint8_t> message) {
    const std::uint64_t size = message.size();
    write({reinterpret_cast<const std::uint8_t*>(&size), sizeof size});
    write(message);
}

void ChildProgram::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        waitFor(POLLOUT);
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0 && errno != EINTR && errno != EAGAIN) refuseEnd();
        if (sent > 0) bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
}

void ChildProgram::read(void* to, std::size_t size) {
    auto* next = static_cast<std::uint8_t*>(to);
    while (size > 0) {
        waitFor(POLLIN);
        const ssize_t count = ::recv(socket_, next, size, MSG_DONTWAIT);
        if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) refuseEnd();
        if (count <= 0) continue;
        next += count;
        size -= static_cast<std::size_t>(count);
    }
}

std::vector<std::uint8_t> ChildProgram::receive() {
    std::uint64_t size = 0;
    read(&size, sizeof size);
    if (size > maxMessage) throw Error{Error::Kind::Input, "found a message that cannot be"};
    std::vector<std::uint8_t> message(size);
    read(message.data(), message.size());
    return message;
}

}  // namespace inkedge::process
