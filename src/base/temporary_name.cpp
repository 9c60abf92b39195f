#include "base/temporary_name.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include <inkedge/write_file.h>

namespace inkedge::base {
namespace {

// A random name: no other process of any machine has it, so that the file can be removed before the name is used.
std::string randomName() {
    std::random_device device;
    return fmt::format(".inkedge-{:08x}{:08x}.tmp", device(), device());
}

}  // namespace

// A signal handler may walk the slots at any moment and on any thread. So a slot is never freed, only used again; and
// only one of the two, its owner or the handler, gets the name out of it.
struct TemporaryName::Slot {
    std::atomic<const char*> name{nullptr};
    std::atomic<bool> used{true};
    const char* taken = nullptr;  // by the handler, which may read it until the process ends: never freed
    Slot* next = nullptr;

    static std::atomic<Slot*> first;
};

std::atomic<TemporaryName::Slot*> TemporaryName::Slot::first{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler may not wait for a lock");

TemporaryName::Slot& TemporaryName::free() {
    for (Slot* slot = Slot::first.load(); slot != nullptr; slot = slot->next) {
        if (!slot->used.exchange(true)) return *slot;
    }
    auto* slot = new Slot;
    slot->next = Slot::first.load();
    while (!Slot::first.compare_exchange_weak(slot->next, slot)) {
    }
    return *slot;
}

TemporaryName::TemporaryName(const std::filesystem::path& folder) {
    const std::string name = (folder / randomName()).string();
    auto copy = std::make_unique<char[]>(name.size() + 1);
    std::memcpy(copy.get(), name.c_str(), name.size() + 1);
    slot_ = &free();
    path_ = copy.release();
    slot_->name.store(path_);
}

TemporaryName::TemporaryName(TemporaryName&& from) noexcept
    : path_{from.path_}, slot_{std::exchange(from.slot_, nullptr)} {}

TemporaryName& TemporaryName::operator=(TemporaryName&& from) noexcept {
    std::swap(path_, from.path_);
    std::swap(slot_, from.slot_);
    return *this;
}

TemporaryName::~TemporaryName() {
    if (slot_ == nullptr) return;
    if (const char* path = slot_->name.exchange(nullptr)) {
        ::unlink(path);
        delete[] path;
    } else {
        slot_->taken = path_;
    }
    slot_->used.store(false);
}

void removeNamed() noexcept {
    for (auto* slot = TemporaryName::Slot::first.load(); slot != nullptr; slot = slot->next) {
        if (const char* path = slot->name.exchange(nullptr)) ::unlink(path);
    }
}

void removeTemporaryFiles() noexcept {
    const int before = errno;
    removeNamed();
    errno = before;
}

}  // namespace inkedge::base
