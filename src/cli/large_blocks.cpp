// The command asks for large pages under its large arrays, as the kernel gives them in its usual setting to who asks
// (madvise(2), MADV_HUGEPAGE): a mesh of millions of triangles is read at random, and would miss the processor's list
// of pages at most of its accesses. A library does not replace its caller's operator new, so that this is the command's
// alone.
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
