#include "process/large_pages.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace inkedge::process {

#ifdef __GLIBC__

void useLargePages() {
    constexpr int heap = 256 << 20;
    constexpr int largestInHeap = 32 << 20;  // glibc takes no more
    constexpr int usualGrowth = 128 << 10;
    constexpr std::size_t moreThanItHas = 1 << 20;
    constexpr std::uintptr_t largePage = 2 << 20;
    mallopt(M_MMAP_THRESHOLD, largestInHeap);
    mallopt(M_TRIM_THRESHOLD, 2 * heap);

    mallopt(M_TOP_PAD, heap);  // the heap grows by this beyond what is asked for
    void* const asked = std::malloc(moreThanItHas);
    mallopt(M_TOP_PAD, usualGrowth);
    const auto begin = (reinterpret_cast<std::uintptr_t>(asked) + largePage - 1) / largePage * largePage;
    const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / largePage * largePage;
    if (asked != nullptr && begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
    std::free(asked);
}

#else

void useLargePages() {}

#endif

}  // namespace inkedge::process
