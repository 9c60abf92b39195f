#include "cli/model_argument.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/load_scene.h>

namespace inkedge::cli {

void addModel(CLI::App& verb, std::string& model) {
    std::vector<std::string_view> names;
    for (const ModelFormat& format : readableFormats()) names.push_back(format.name);
    const std::string_view last = names.back();
    names.pop_back();
    verb.add_option("MODEL", model, fmt::format("{} or {} file", fmt::join(names, ", "), last))->required();
}

}  // namespace inkedge::cli
