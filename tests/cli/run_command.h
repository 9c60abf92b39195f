#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Arguments = std::vector<std::string>;
using Environment = std::vector<std::pair<std::string, std::string>>;

/// What a command did.
struct Outcome {
    int exitCode = -1;  ///< over 128: ended by signal exitCode - 128
    std::string out;
    std::string error;
    double seconds = 0.0;         ///< of a processor
    std::uint64_t peakBytes = 0;  ///< the most memory that it held at once
};

/// A program that runs in a folder of the caller's, with its environment and these variables besides.
class Running {
public:
    /// @param prepare  called in the new process just before the program starts, to change its streams, limits, ...
    /// @throws std::runtime_error  if it cannot be started
    Running(const std::filesystem::path& program, const Arguments& arguments, const std::filesystem::path& folder,
            const Environment& environment = {}, const std::function<void()>& prepare = {})
        : name_{program.string()} {
        for (auto& ends : pipes_) {
            if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error{"no pipe"};
        }
        std::vector<char*> argv{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);

        child_ = ::fork();
        if (child_ < 0) throw std::runtime_error{"no process"};
        if (child_ == 0) {
            for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
            for (const int signal : {SIGHUP, SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);  // ours may be ignored
            ::dup2(pipes_[0][1], STDOUT_FILENO);
            ::dup2(pipes_[1][1], STDERR_FILENO);
            if (prepare) prepare();
            if (::chdir(folder.c_str()) == 0) ::execv(argv[0], argv.data());
            ::_exit(127);
        }
        for (auto& ends : pipes_) ::close(std::exchange(ends[1], -1));
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
        if (child_ > 0) (void)end(true);
        for (const auto& ends : pipes_) ::close(ends[0]);
    }

    [[nodiscard]] pid_t process() const noexcept { return child_; }

    /// Reads what it says until it ends.
    /// @throws std::runtime_error  if it runs for longer than the limit; it is then killed
    Outcome finish(std::chrono::seconds limit = std::chrono::seconds{120}) {
        Outcome outcome;
        std::array<pollfd, 2> open{pollfd{pipes_[0][0], POLLIN, 0}, pollfd{pipes_[1][0], POLLIN, 0}};
        const std::array<std::string*, 2> texts{&outcome.out, &outcome.error};
        const auto deadline = std::chrono::steady_clock::now() + limit;
        bool late = false;
        while (!late && (open[0].fd >= 0 || open[1].fd >= 0)) {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now())
                    .count();
            late = left <= 0 || ::poll(open.data(), open.size(), static_cast<int>(left)) == 0;
            for (std::size_t i = 0; i < open.size() && !late; ++i) {
                if (open[i].fd < 0 || open[i].revents == 0) continue;
                std::array<char, 65536> bytes;
                const ssize_t count = ::read(open[i].fd, bytes.data(), bytes.size());
                if (count > 0) texts[i]->append(bytes.data(), static_cast<std::size_t>(count));
                if (count == 0 || (count < 0 && errno != EINTR)) open[i].fd = -1;
            }
        }
        rusage used{};
        const int status = end(late, &used);
        if (late) throw std::runtime_error{name_ + " ran for longer than " + std::to_string(limit.count()) + " s"};
        outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        outcome.seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
        outcome.peakBytes = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
        return outcome;
    }

private:
    static double seconds(const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }

    int end(bool kill, rusage* used = nullptr) {
        const pid_t child = std::exchange(child_, -1);
        if (kill) ::kill(child, SIGKILL);
        int status = 0;
        while (::wait4(child, &status, 0, used) < 0 && errno == EINTR) {
        }
        return status;
    }

    std::string name_;
    std::array<std::array<int, 2>, 2> pipes_{};  // stdout, stderr; read end, write end
    pid_t child_ = -1;
};

/// Runs a program to its end.
/// @throws std::runtime_error  if it cannot be started or runs for longer than the limit; it is then killed
inline Outcome runCommand(const std::filesystem::path& program, const Arguments& arguments,
                          const std::filesystem::path& folder, const Environment& environment = {},
                          std::chrono::seconds limit = std::chrono::seconds{120}) {
    return Running{program, arguments, folder, environment}.finish(limit);
}
