// Large pages under large arrays that lie beyond the heap of process/large_pages.h, as those of millions of triangles
// do: these are read at random, and with pages of 4 KiB the processor would look up most accesses' pages anew. The
// kernel's usual setting is to give them to who asks (madvise(2)). A library does not replace its caller's operator
// new, so that this is the command's alone.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace {

constexpr std::size_t largeBlock = std::size_t{4} << 20U;  // bytes: two large pages, so that it holds a whole one

void askForLargePages(void* block, std::size_t size) noexcept {
    constexpr std::uintptr_t page = 4096;
    const auto address = reinterpret_cast<std::uintptr_t>(block);
    const std::uintptr_t begin = (address + page - 1) / page * page;
    const std::uintptr_t end = (address + size) / page * page;
    static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));  // may be refused
}

}  // namespace

void* operator new(std::size_t size) {
    void* block = nullptr;
    while ((block = std::malloc(size == 0 ? 1 : size)) == nullptr) {
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc{};
        handler();
    }
    if (size >= largeBlock) askForLargePages(block, size);
    return block;
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
