#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <inkedge/error.h>

namespace inkedge::process {

/// A program ended before it had answered.
class ProgramEnded : public Error {
public:
    ProgramEnded(const std::string& message, int signal) : Error{Kind::Input, message}, signal_{signal} {}
    /// That ended it; 0: it ended by itself.
    [[nodiscard]] int signal() const noexcept { return signal_; }

private:
    int signal_;
};

/// A program in a process of its own, for work that may crash or never end, from any thread. It finds some bytes as its
/// descriptor 3 and a socket as its descriptor 4, on which both sides send messages: eight bytes of a size, then so
/// many bytes. Its other streams are closed to it. It ends when this ends.
class ChildProgram {
public:
    /// @param limit    of the program's processor time, and of the clock's while it waits for anything but a processor,
    ///                 from its start on: send() and receive() wait no longer
    /// @param waiting  called many times a second while the program is waited for; may throw
    /// @throws Error   (Kind::Runtime) if it cannot be started
    ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 std::span<const std::uint8_t> bytes, std::chrono::duration<double> limit,
                 std::function<void()> waiting);
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;
    ~ChildProgram();

    /// @param limit  in the place of the first one; from the start on, too
    void setLimit(std::chrono::duration<double> limit) noexcept { limit_ = limit; }

    /// @throws Error  as receive()
    void send(std::span<const std::uint8_t> message);

    /// Waits for the next message.
    /// @throws ProgramEnded  if the program ends before: "found a crash (Segmentation fault)", "found exit status 1"
    /// @throws Error         (Kind::Input) if it takes too long: "found it still at work after 600 s"; what waiting()
    ///                       throws
    [[nodiscard]] std::vector<std::uint8_t> receive();

    [[nodiscard]] pid_t process() const noexcept { return child_; }

private:
    [[nodiscard]] std::chrono::duration<double> processorTime() const;
    /// Whether none of the program's threads runs, could run if there were a processor for it, or is stopped: neither a
    /// busy machine nor SIGSTOP makes a program late.
    [[nodiscard]] bool sleeps() const;
    void waitFor(short event);
    void write(std::span<const std::uint8_t> bytes);
    void read(void* to, std::size_t size);
    [[noreturn]] void refuseEnd();

    std::chrono::duration<double> slept_{0.0};  // while it was waited for
    std::chrono::duration<double> limit_;
    std::function<void()> waiting_;
    int socket_ = -1;
    pid_t child_ = -1;
};

}  // namespace inkedge::process
