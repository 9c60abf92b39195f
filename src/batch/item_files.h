#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "base/staged_files.h"
#include "batch/plan.h"

namespace inkedge::batch {

/// The files of one item on their way into its folder, view by view, or into its part of a shard, all at once. Of an
/// item that was not finished there may be views in its folder; the file that comes last is not there then.
class ItemFiles {
public:
    /// @throws Error  (Kind::Output) if its folder cannot be made
    ItemFiles(const Planner&, const Plan&, const std::string& id, const std::string& key);

    /// @throws Error  (Kind::Output) as StagedFiles
    void add(const std::filesystem::path& name, std::span<const std::uint8_t> bytes);
    void finishView();
    void finish();

private:
    bool shards_;
    std::string id_;
    std::filesystem::path folder_;
    base::StagedFiles files_;
};

}  // namespace inkedge::batch
