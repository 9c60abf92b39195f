#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "batch/portion.h"

namespace inkedge::batch {

/// An open file, closed with the object.
class OpenFile {
public:
    /// Not open if it cannot be read.
    explicit OpenFile(const std::filesystem::path&);
    ~OpenFile();
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    [[nodiscard]] bool isOpen() const noexcept { return descriptor_ >= 0; }
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    [[nodiscard]] std::uint64_t size() const noexcept;

private:
    int descriptor_;
};

/// A shard that was there when the batch began, or that another process has written.
struct OldShard {
    std::uint64_t number;
    OpenFile file;
    struct Range {
        std::uint64_t begin = 0;
        std::uint64_t end = 0;
    };
    std::unordered_map<std::string, Range> items;  // by id
    std::uint64_t end = 0;                         // of the last item

    OldShard(const std::filesystem::path&, std::uint64_t number);
};

/// 000007.tar, or 3-of-8.000007.tar of a portion.
[[nodiscard]] std::filesystem::path shardFile(const std::filesystem::path& output, const Portion&,
                                              std::uint64_t number);

/// What the name of a shard says of it.
struct ShardName {
    std::string portion;  ///< nameOf() it
    std::uint64_t number = 0;
};
/// The shards in a batch's folder.
[[nodiscard]] std::vector<ShardName> shardsIn(const std::filesystem::path& output);

/// Looks for items, in about the order in which they lie in the shards; three of these are held at a time.
class OldShards {
public:
    OldShards(std::filesystem::path output, Portion);

    struct Found {
        std::shared_ptr<const OldShard> shard;
        OldShard::Range range;
    };
    /// Thread-safe only one call at a time.
    [[nodiscard]] std::optional<Found> find(const std::string& id);

private:
    std::shared_ptr<const OldShard> shard(std::size_t index);

    std::filesystem::path output_;
    Portion portion_;
    std::vector<std::uint64_t> numbers_;  // of all shards, rising
    std::size_t current_ = 0;             // index of the one where the last item was found
    std::map<std::size_t, std::shared_ptr<const OldShard>> open_;
};

}  // namespace inkedge::batch
