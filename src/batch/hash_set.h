#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace inkedge::batch {

/// Hashes of 64 bits, in 11 to 22 bytes each: ten millions take 134 MB. That two texts among so many have one hash
/// happens once in 370,000 times.
class HashSet {
public:
    /// @return whether it was not there
    bool insert(std::uint64_t hash) {
        if (4 * (count_ + 1) > 3 * slots_.size()) grow();
        std::uint64_t& slot = slotOf(hash);
        if (slot != 0) return false;
        slot = stored(hash);
        ++count_;
        return true;
    }
    [[nodiscard]] bool contains(std::uint64_t hash) const {
        return !slots_.empty() && const_cast<HashSet*>(this)->slotOf(hash) != 0;
    }
    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }

private:
    static std::uint64_t stored(std::uint64_t hash) noexcept { return hash == 0 ? 1 : hash; }  // 0: a free slot

    std::uint64_t& slotOf(std::uint64_t hash) {
        const std::uint64_t value = stored(hash);
        std::size_t i = value & (slots_.size() - 1);
        while (slots_[i] != 0 && slots_[i] != value) i = (i + 1) & (slots_.size() - 1);
        return slots_[i];
    }
    void grow() {
        std::vector<std::uint64_t> before(slots_.empty() ? 1024 : 2 * slots_.size());
        std::swap(before, slots_);
        for (const std::uint64_t hash : before)
            if (hash != 0) slotOf(hash) = hash;
    }

    std::vector<std::uint64_t> slots_;  // as many as a power of two
    std::size_t count_ = 0;
};

}  // namespace inkedge::batch
