#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// The other side of ChildProgram: what programs do that it starts.
namespace inkedge::process {

/// The descriptors that the program finds open.
inline constexpr int bytesDescriptor = 3;    ///< the bytes that it was given
inline constexpr int messageDescriptor = 4;  ///< a socket: messages, each after its size

/// Reads or writes all; where nobody is at the other end any more, the process ends.
inline void transfer(void* data, std::size_t size, ssize_t (*call)(int, void*, std::size_t)) {
    auto* next = static_cast<std::uint8_t*>(data);
    while (size > 0) {
        const ssize_t count = call(messageDescriptor, next, size);
        if (count == 0 || (count < 0 && errno != EINTR)) ::_exit(1);
        if (count < 0) continue;
        next += count;
        size -= static_cast<std::size_t>(count);
    }
}

inline void sendMessage(std::span<const std::uint8_t> message) {
    std::uint64_t size = message.size();
    const auto write = [](int to, void* from, std::size_t count) { return ::write(to, from, count); };
    transfer(&size, sizeof size, write);
    transfer(const_cast<std::uint8_t*>(message.data()), message.size(), write);  // it is read alone
}

[[nodiscard]] inline std::vector<std::uint8_t> receiveMessage() {
    std::uint64_t size = 0;
    transfer(&size, sizeof size, ::read);
    std::vector<std::uint8_t> message(size);
    transfer(message.data(), message.size(), ::read);
    return message;
}

/// All bytes that the program was given, as text.
[[nodiscard]] inline std::string givenText() {
    std::string text;
    std::array<char, 4096> bytes;
    for (ssize_t count = 0; (count = ::read(bytesDescriptor, bytes.data(), bytes.size())) != 0;)
        if (count > 0)
            text.append(bytes.data(), static_cast<std::size_t>(count));
        else if (errno != EINTR)
            break;
    return text;
}

/// Nothing of this process stays behind when the one that asked ends, and none of its memory goes into a file.
inline void becomeDependent() {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    // Where memory runs out this process ends first, and the one that asked can say so.
    if (const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); file >= 0) {
        static_cast<void>(::write(file, "800", 3));
        ::close(file);
    }
}

}  // namespace inkedge::process
