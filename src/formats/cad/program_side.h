#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "formats/cad/model.h"
#include "formats/cad/pack.h"
#include "modules/failure.h"

// What programs have in common that read files for the library, each in a process of its own: libraries may crash over
// a file, or never end.
namespace inkedge::cad {

inline void transfer(void* data, std::size_t size, ssize_t (*call)(int, void*, std::size_t)) {
    auto* next = static_cast<std::uint8_t*>(data);
    while (size > 0) {
        const ssize_t count = call(messageDescriptor, next, size);
        if (count == 0 || (count < 0 && errno != EINTR)) ::_exit(1);  // nobody asks any more
        if (count < 0) continue;
        next += count;
        size -= static_cast<std::size_t>(count);
    }
}

template <class T>
void send(const T& value) {
    std::vector<std::uint8_t> bytes = packed(value);
    std::uint64_t size = bytes.size();
    const auto write = [](int to, void* from, std::size_t count) { return ::write(to, from, count); };
    transfer(&size, sizeof size, write);
    transfer(bytes.data(), bytes.size(), write);
}

template <class T>
T receive() {
    std::uint64_t size = 0;
    transfer(&size, sizeof size, ::read);
    std::vector<std::uint8_t> bytes(size);
    transfer(bytes.data(), bytes.size(), ::read);
    return unpacked<T>(bytes);
}

/// Sends a model of which nothing is to be asked.
inline void sendReady(const Model& model) {
    Outline ready;
    ready.ready = true;
    send(ready);
    send(model);
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

/// Does the work of such a program and ends it. What the work throws, or returns if it is not empty, is sent as the
/// reason why there is no model.
template <class Work>
[[noreturn]] void runProgram(Work work) {
    becomeDependent();
    Outline failed;
    try {
        failed.failure = work();
    } catch (const std::bad_alloc&) {
        failed.failure = modules::outOfMemory;
    } catch (const std::exception& exception) {
        failed.failure = modules::oneLine(exception.what());
    }
    if (!failed.failure.empty()) send(failed);
    ::_exit(0);  // what the libraries would tidy up ends with the process
}

}  // namespace inkedge::cad
