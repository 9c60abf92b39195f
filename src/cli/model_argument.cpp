#include "cli/model_argument.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/load_scene.h>

namespace inkedge::cli {
namespace {

std::string formats() {
    std::vector<std::string_view> names;
    for (const ModelFormat& format : readableFormats()) names.push_back(format.name);
    const std::string_view last = names.back();
    names.pop_back();
    return fmt::format("{} or {} file", fmt::join(names, ", "), last);
}

}  // namespace

void addModel(CLI::App& verb, std::string& model) { verb.add_option("MODEL", model, formats())->required(); }

void addModels(CLI::App& verb, std::vector<std::string>& models) {
    verb.add_option("MODEL", models, formats() + "; of several, --output needs {model}");
}

}  // namespace inkedge::cli
