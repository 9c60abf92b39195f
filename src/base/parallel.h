#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace inkedge::base {

/// How many cores this process may use, which may be fewer than the machine has; 1 at least.
[[nodiscard]] std::size_t usableCores();

/// How many elements are worth a thread of their own: starting one takes about as long as a few thousand of them.
inline constexpr std::size_t elementsWorthAThread = 100'000;

/// Calls work(begin, end) for ranges that together cover 0..count, each on a thread of its own. There are as many
/// ranges as this process has cores, but at most 8; for fewer than twice elementsWorthAThread it is one call on this
/// thread. The caller must make sure that different ranges write to different memory, and that the result does not
/// depend on where the ranges begin and end.
/// @throws  what the first range that failed has thrown; what stopIfAsked() throws, which is called before each
void inRanges(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& work);

/// The results of work(begin, end) for ranges as those of inRanges(), in the order of the ranges.
template <class Work>
[[nodiscard]] auto partsOf(std::size_t count, Work work) {
    using Part = decltype(work(std::size_t{}, std::size_t{}));
    std::mutex mutex;
    std::map<std::size_t, Part> byBegin;
    inRanges(count, [&](std::size_t begin, std::size_t end) {
        Part part = work(begin, end);
        const std::scoped_lock lock{mutex};
        byBegin.emplace(begin, std::move(part));
    });
    std::vector<Part> parts;
    for (auto& [begin, part] : byBegin) parts.push_back(std::move(part));
    return parts;
}

/// Calls work(i) for 0..count-1 on all cores of this process, in no order: for independent pieces of work of any size.
/// @throws  what the first piece that failed has thrown; what stopIfAsked() throws, which is called before each
void onEach(std::size_t count, const std::function<void(std::size_t i)>& work);

}  // namespace inkedge::base
