#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "batch/batch.h"
#include "batch/old_shards.h"

namespace inkedge::batch {

/// Puts the parts of items together to shards, in the order of the items. A shard is written whole or not at all.
class Shards {
public:
    Shards(std::filesystem::path output, ShardSize, Portion = {});

    /// Takes an item that was drawn by a run before this one.
    /// @return  whether its files are still there, in its part or in a shard
    [[nodiscard]] bool takeEarlier(std::uint64_t number, const std::string& id, const std::filesystem::path& part);
    /// Takes an item's part, which is there now.
    void take(std::uint64_t number, const std::string& id, const std::filesystem::path& part);
    /// Nothing comes of an item.
    void leaveOut(std::uint64_t number);

    /// Writes the shards that have all their items. To be called by one thread.
    /// @throws Error  (Kind::Output) if one cannot be written
    void write();
    /// Writes the last one, too, and removes those after it of another run.
    void finish();

private:
    // Where an item's files lie.
    struct Source {
        std::string id;
        std::filesystem::path part;                  // empty: in the shard
        std::shared_ptr<const OldShard> shard = {};  // null: in the part; neither: there are none
        OldShard::Range range = {};
    };

    void add(std::uint64_t number, Source source);
    [[nodiscard]] bool isFull(const Source& next) const;
    [[nodiscard]] bool isThere() const;
    void close();
    void writeShard(const std::filesystem::path& file);

    std::filesystem::path output_;
    ShardSize size_;
    Portion portion_;
    std::mutex mutex_;
    OldShards old_;
    std::map<std::uint64_t, Source> ready_;  // items that came before those that are before them
    std::uint64_t next_ = 0;                 // item of the current shard
    std::vector<Source> current_;
    std::uint64_t bytes_ = 0;
    std::uint64_t number_ = 0;
};

}  // namespace inkedge::batch
