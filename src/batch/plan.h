#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <inkedge/job.h>
#include <inkedge/views.h>

#include "batch/batch.h"
#include "batch/item.h"

namespace inkedge::batch {

/// An item's work: what is drawn of it.
struct Plan {
    Job job;                  ///< names of files are within the item's folder
    std::vector<View> views;  ///< of the job, one at least
    bool score = false;       ///< Batch::score
    std::string settings;     ///< what makes a difference to the files, as text
};

/// What of a batch concerns items: a worker is told it when it begins.
class Planner {
public:
    explicit Planner(const Batch&);
    /// @param text  of another planner
    explicit Planner(const std::string& text);

    [[nodiscard]] std::string text() const;

    /// @throws Error  (Kind::Usage) if a setting or a view of the item is wrong; (Kind::Input) if its list of views
    ///                cannot be read
    [[nodiscard]] Plan planOf(const Item&) const;

    [[nodiscard]] const std::filesystem::path& output() const noexcept { return output_; }
    [[nodiscard]] bool shards() const noexcept { return shards_; }
    /// What is drawn of all items that say nothing else.
    [[nodiscard]] const Plan& common() const noexcept { return common_; }

private:
    void prepare();

    std::filesystem::path output_;
    Settings settings_;
    std::string views_;
    std::vector<std::string> formats_;
    bool shards_ = false;
    Plan common_;
};

/// The settings that differ from their defaults, by name, as text.
[[nodiscard]] io::Json differencesOf(const Settings&);

/// The name of the file that holds a view's camera, within the item's folder.
[[nodiscard]] std::string cameraFileOf(const View&);

/// All files of an item within its folder, in the order in which they are written.
/// @throws Error  (Kind::Usage) as filesOf()
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const Plan&);

/// Distinguishes what is drawn of a model: by its content, the settings and the version.
/// @return  32 digits
[[nodiscard]] std::string keyOf(const Plan&, const std::filesystem::path& model);

/// Where an item's files are gathered on their way into a shard, within the output.
[[nodiscard]] std::filesystem::path partOf(const std::string& id, const std::string& key);

}  // namespace inkedge::batch
