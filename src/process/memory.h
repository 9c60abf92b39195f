#pragma once

#include <sys/types.h>

#include <cstdint>

namespace inkedge::process {

/// Bytes of memory that a process and those that its first thread has started hold now; 0 if it is not there.
[[nodiscard]] std::uint64_t heldMemory(pid_t);

/// Bytes that this process and those it starts may hold together: the machine's, or its control group's limit.
[[nodiscard]] std::uint64_t memoryLimit();

}  // namespace inkedge::process
