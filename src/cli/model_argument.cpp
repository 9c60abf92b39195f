#include "cli/model_argument.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>
#include <inkedge/load_scene.h>

#include "cli/checks.h"
#include "cli/streams.h"

namespace inkedge::cli {
namespace {

constexpr const char* standardInput = "-";

std::string formats() {
    std::vector<std::string_view> names;
    for (const ModelFormat& format : readableFormats()) names.push_back(format.name);
    const std::string_view last = names.back();
    names.pop_back();
    return fmt::format("{} or {} file, or - for stdin", fmt::join(names, ", "), last);
}

std::vector<std::string> extensionsWithoutDots() {
    std::vector<std::string> all;
    for (const ModelFormat& format : readableFormats())
        for (const std::string_view extension : format.extensions) all.emplace_back(extension.substr(1));
    return all;
}

}  // namespace

void ModelArgument::addFormatTo(CLI::App& verb) {
    const std::vector<std::string> extensions = extensionsWithoutDots();
    verb.add_option("--format", format_, "of a model from stdin; without it its first bytes decide")
        ->check(oneOf(extensions))
        ->type_name(fmt::format("{}", fmt::join(extensions, "|")));
}

void ModelArgument::addTo(CLI::App& verb) {
    const auto take = [this](const std::string& name) { names_ = {name}; };
    verb.add_option_function<std::string>("MODEL", take, formats())->required();
    addFormatTo(verb);
}

void ModelArgument::addSeveralTo(CLI::App& verb) {
    verb.add_option("MODEL", names_, formats() + "; of several, --output needs {model}");
    addFormatTo(verb);
}

std::vector<GivenModel> ModelArgument::models(const LoadLimits& limits) const {
    const auto fromStandardInput = std::ranges::count(names_, standardInput);
    if (fromStandardInput > 1)
        throw Error{Error::Kind::Usage, fmt::format("MODEL: expected - once, found it {} times", fromStandardInput)};
    if (fromStandardInput == 0 && !format_.empty())
        throw Error{Error::Kind::Usage, fmt::format("--format: expected the model -, found {}; the format of a file is "
                                                    "known by its extension and its first bytes",
                                                    fmt::join(names_, ", "))};
    std::vector<GivenModel> models;
    for (const std::string& name : names_) {
        if (name == standardInput)
            models.push_back({format_.empty() ? "stdin" : "stdin." + format_, readStandardInput(limits.fileSize)});
        else
            models.push_back({name});
    }
    return models;
}

}  // namespace inkedge::cli
