#include "batch/find_models.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <inkedge/load_scene.h>

#include "base/file_extension.h"
#include "base/message.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

bool isModel(const fs::path& file) {
    static const std::set<std::string, std::less<>> extensions = [] {
        std::set<std::string, std::less<>> all;
        for (const ModelFormat& format : readableFormats())
            for (const std::string_view extension : format.extensions) all.emplace(extension);
        return all;
    }();
    return extensions.contains(base::lowerCaseExtension(file));
}

}  // namespace

FindModels::FindModels(fs::path folder, fs::path leftOut) : leftOut_{std::move(leftOut)} {
    open_.push_back({std::move(folder)});
}

void FindModels::enter(const fs::path& folder) {
    std::error_code failure;
    std::vector<fs::path> names;
    for (fs::directory_iterator entry{folder, failure}; !failure && entry != fs::directory_iterator{};
         entry.increment(failure)) {
        const fs::path& path = entry->path();
        if (path.filename().native().starts_with('.')) continue;
        std::error_code ignored;
        if (entry->symlink_status(ignored).type() == fs::file_type::directory || isModel(path)) names.push_back(path);
    }
    if (failure)
        base::refuse(
            fmt::format("{}: expected a folder that can be read, found: {}", folder.string(), failure.message()));
    std::ranges::sort(names, std::greater{});
    open_.push_back(std::move(names));
}

std::optional<fs::path> FindModels::next() {
    while (!open_.empty()) {
        if (open_.back().empty()) {
            open_.pop_back();
            continue;
        }
        fs::path path = std::move(open_.back().back());
        open_.back().pop_back();
        std::error_code ignored;
        const bool first = open_.size() == 1;  // the folder itself may be behind a link
        const fs::file_status status = first ? fs::status(path, ignored) : fs::symlink_status(path, ignored);
        if (status.type() != fs::file_type::directory) return path;
        if (!fs::equivalent(path, leftOut_, ignored)) enter(path);
    }
    return {};
}

}  // namespace inkedge::batch
