#include "process/memory.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

namespace inkedge::process {
namespace {

namespace fs = std::filesystem;

std::uint64_t ownMemory(pid_t process) {
    std::ifstream file{fmt::format("/proc/{}/statm", process)};
    std::uint64_t all = 0;
    std::uint64_t resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// Of the control groups around this process the smallest limit; version 2 of them.
std::uint64_t groupLimit(std::uint64_t limit) {
    std::ifstream groups{"/proc/self/cgroup"};
    std::string line;
    while (std::getline(groups, line) && !line.starts_with("0::/")) {
    }
    if (!groups) return limit;
    const fs::path root = "/sys/fs/cgroup";
    for (fs::path group = root / line.substr(4); group.native().size() > root.native().size();
         group = group.parent_path()) {
        std::uint64_t max = 0;
        if (std::ifstream file{group / "memory.max"}; file >> max) limit = std::min(limit, max);
    }
    return limit;
}

}  // namespace

std::uint64_t heldMemory(pid_t process) {
    std::uint64_t held = ownMemory(process);
    std::ifstream children{fmt::format("/proc/{0}/task/{0}/children", process)};
    for (pid_t child = 0; children >> child;) held += ownMemory(child);
    return held;
}

std::uint64_t memoryLimit() {
    const auto pages = static_cast<std::uint64_t>(std::max(::sysconf(_SC_PHYS_PAGES), 1L));
    return groupLimit(pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
}

}  // namespace inkedge::process
