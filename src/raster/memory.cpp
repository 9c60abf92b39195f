#include "raster/memory.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::raster {
namespace {

constexpr std::uint64_t worthAsking = std::uint64_t{1} << 28U;  // bytes: every machine has less than this

std::optional<std::uint64_t> numberIn(const char* file) {
    std::uint64_t number = 0;
    std::ifstream stream{file};
    return stream >> number ? std::optional{number} : std::nullopt;
}

// The memory that the machine has available.
std::optional<std::uint64_t> machineMemory() {
    std::ifstream stream{"/proc/meminfo"};
    std::optional<std::uint64_t> available;
    std::uint64_t swap = 0;
    std::string name;
    std::uint64_t kibibytes = 0;
    std::string rest;
    while (stream >> name >> kibibytes && std::getline(stream, rest)) {
        if (name == "MemAvailable:") available = kibibytes * 1024;
        if (name == "SwapFree:") swap = kibibytes * 1024;
    }
    return available ? std::optional{*available + swap} : std::nullopt;
}

// What is left of the container's memory, if the container has a limit.
std::optional<std::uint64_t> shareLeft() {
    const auto limit = numberIn("/sys/fs/cgroup/memory.max");
    const auto used = numberIn("/sys/fs/cgroup/memory.current");
    if (!limit || !used) return {};
    return *limit - std::min(*limit, *used);
}

}  // namespace

std::optional<std::uint64_t> availableMemory() {
    const auto machine = machineMemory();
    const auto share = shareLeft();
    return machine && share ? std::min(*machine, *share) : machine ? machine : share;
}

void expectMemory(Size picture, std::uint64_t bytesPerPixel) {
    const std::uint64_t bytes =
        static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height) * bytesPerPixel;
    if (bytes < worthAsking) return;
    const auto available = availableMemory();
    if (!available || bytes <= *available) return;
    constexpr double gibibyte = 1 << 30U;
    throw Error{
        Error::Kind::Runtime,
        fmt::format("a picture of {} x {} pixels with its maps: expected {:.1f} GiB of memory, found {:.1f}; ask "
                    "for a smaller --size or fewer --maps",
                    picture.width, picture.height, static_cast<double>(bytes) / gibibyte,
                    static_cast<double>(*available) / gibibyte)};
}

}  // namespace inkedge::raster
