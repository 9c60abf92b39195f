#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "batch/batch.h"
#include "batch/hash_set.h"

namespace inkedge::batch {

/// What earlier runs have done, by id and key: 11 to 22 bytes an item that was drawn.
class Earlier {
public:
    explicit Earlier(const Batch& batch) : batch_{batch} {}

    /// Takes a line of the results.
    void take(std::string_view line);

    /// What became of an item that is not to be done again; State::Drawn holds as long as its files are there.
    [[nodiscard]] std::optional<State> find(const std::string& id, const std::string& key) const;
    [[nodiscard]] bool empty() const noexcept { return drawn_.empty() && failed_.empty(); }

private:
    const Batch& batch_;
    HashSet drawn_;
    std::unordered_map<std::uint64_t, State> failed_;
};

}  // namespace inkedge::batch
