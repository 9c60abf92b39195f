#include "batch/item_files.h"

#include <system_error>

#include <fmt/format.h>

#include "batch/tar.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

void makeFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        base::failToWrite(folder, fmt::format("expected a folder or room for one, found: {}", failure.message()));
}

}  // namespace

ItemFiles::ItemFiles(const Planner& planner, const Plan& plan, const std::string& id, const std::string& key)
    : shards_{planner.shards()}, id_{id}, folder_{planner.output() / id} {
    if (shards_) {
        files_.add(planner.output() / partOf(id, key), {});
        return;
    }
    makeFolder(folder_);
    std::error_code ignored;  // it is seldom there
    fs::remove(folder_ / cameraFileOf(plan.views.back()), ignored);
}

void ItemFiles::add(const fs::path& name, std::span<const std::uint8_t> bytes) {
    if (!shards_) return files_.add(folder_ / name, bytes);
    files_.extend(tarHeader((fs::path{id_} / name).string(), bytes.size()));
    files_.extend(bytes);
    files_.extend(tarPadding(bytes.size()));
}

void ItemFiles::finishView() {
    if (!shards_) files_.commit();
}

void ItemFiles::finish() { files_.commit(); }

}  // namespace inkedge::batch
