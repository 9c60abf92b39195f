#pragma once

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
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
};

/// Runs a program to its end in a folder, with an environment of the caller's and these variables besides.
/// @throws std::runtime_error  if it cannot be started or runs for longer than the limit; it is then killed
inline Outcome runCommand(const std::filesystem::path& program, const Arguments& arguments,
                          const std::filesystem::path& folder, const Environment& environment = {},
                          std::chrono::seconds limit = std::chrono::seconds{120}) {
    std::array<std::array<int, 2>, 2> pipes{};  // stdout, stderr; read end, write end
    for (auto& ends : pipes) {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error{"no pipe"};
    }
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error{"no process"};
    if (child == 0) {
        for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
        ::dup2(pipes[0][1], STDOUT_FILENO);
        ::dup2(pipes[1][1], STDERR_FILENO);
        if (::chdir(folder.c_str()) == 0) ::execv(argv[0], argv.data());
        ::_exit(127);
    }

    Outcome outcome;
    std::array<pollfd, 2> open{pollfd{pipes[0][0], POLLIN, 0}, pollfd{pipes[1][0], POLLIN, 0}};
    const std::array<std::string*, 2> texts{&outcome.out, &outcome.error};
    for (const auto& ends : pipes) ::close(ends[1]);
    const auto end = std::chrono::steady_clock::now() + limit;
    bool late = false;
    while (!late && (open[0].fd >= 0 || open[1].fd >= 0)) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
        late = left <= 0 || ::poll(open.data(), open.size(), static_cast<int>(left)) == 0;
        for (std::size_t i = 0; i < open.size() && !late; ++i) {
            if (open[i].fd < 0 || open[i].revents == 0) continue;
            std::array<char, 65536> bytes;
            const ssize_t count = ::read(open[i].fd, bytes.data(), bytes.size());
            if (count > 0) texts[i]->append(bytes.data(), static_cast<std::size_t>(count));
            if (count == 0 || (count < 0 && errno != EINTR)) open[i].fd = -1;
        }
    }
    for (const auto& ends : pipes) ::close(ends[0]);
    if (late) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (late)
        throw std::runtime_error{program.string() + " ran for longer than " + std::to_string(limit.count()) + " s"};
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}
