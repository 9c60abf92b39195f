#include "job/file_names.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

namespace inkedge {
namespace job {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

struct Field {
    std::string_view placeholder;
    std::string value;
};

// Fills in every field in one go, so that no value is taken for a field.
std::string expanded(std::string_view text, std::span<const Field> fields) {
    std::string whole;
    while (!text.empty()) {
        const auto field =
            std::ranges::find_if(fields, [&](const Field& each) { return text.starts_with(each.placeholder); });
        if (field == fields.end()) {
            whole += text.front();
            text.remove_prefix(1);
        } else {
            whole += field->value;
            text.remove_prefix(field->placeholder.size());
        }
    }
    return whole;
}

bool leadsOut(const fs::path& part) { return part == "." || part == ".."; }

// A name that is filled in makes no folder of its own and leads to no other than the text does.
void expectWithin(const std::string& text, const fs::path& file, std::span<const Field> fields) {
    for (const Field& field : fields) {
        if (text.find(field.placeholder) == std::string::npos) continue;
        const fs::path written{text};
        const bool within = std::ranges::count_if(file, leadsOut) == std::ranges::count_if(written, leadsOut) &&
                            file.is_absolute() == written.is_absolute();
        if (within && field.value.find_first_of("/\0"sv) == std::string::npos) continue;
        throw Error{
            Error::Kind::Usage,
            fmt::format("{}: expected a name for {} that stays in the folder, found '{}'; name the file without "
                        "it",
                        text, field.placeholder, field.value)};
    }
}

fs::path expandTemplate(const std::string& text, const Job& job, const View& view) {
    const std::array fields{Field{"{model}", job.model.stem().string()}, Field{"{view}", view.name}};
    const fs::path file = expanded(text, fields);
    expectWithin(text, file, fields);
    return file;
}

}  // namespace

void expectKnownFields(const std::string& text) {
    constexpr std::array known{"{model}"sv, "{view}"sv, "{map}"sv};
    for (std::size_t i = text.find('{'); i != std::string::npos; i = text.find('{', i + 1)) {
        const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz", i + 1);
        if (end == std::string::npos || end == i + 1 || text[end] != '}') continue;
        const std::string field = text.substr(i, end + 1 - i);
        if (std::ranges::find(known, field) == known.end())
            throw Error{
                Error::Kind::Usage,
                fmt::format("{}: expected {{model}}, {{view}} or {{map}} to be filled in, found {}", text, field)};
    }
}

std::vector<View> viewsOf(const Job& job) {
    if (!job.views.empty()) return job.views;
    const bool named = job.settings.camera.view.has_value();
    return {{named ? findSetting("view")->get(job.settings) : "0", job.settings.camera}};
}

std::vector<fs::path> filesOfOutput(const Job& job, const std::string& output, const View& view) {
    std::vector<fs::path> files;
    if (holdsLines(output)) {
        const std::array outline{Field{"{map}", "outline"}};
        files.emplace_back(expanded(output, outline));
    } else {
        files = outputFiles(output, mapsIn(output, job.settings));
    }
    for (fs::path& file : files) file = expandTemplate(file.string(), job, view);
    return files;
}

fs::path metadataFileOf(const Job& job, const View& view) { return expandTemplate(job.metadata, job, view); }

bool hasOneMetadataFile(const Job& job) {
    return viewsOf(job).size() > 1 && !job.metadata.empty() && job.metadata.find("{view}") == std::string::npos;
}

std::vector<Map> mapsIn(const std::string& output, const Settings& settings) {
    return settings.maps.empty() ? defaultMaps(output) : settings.maps;
}

Settings withMapsOf(const std::vector<std::string>& outputs, Settings settings) {
    const Settings asked = settings;
    for (const std::string& output : outputs) {
        if (holdsLines(output)) continue;
        for (const Map map : mapsIn(output, asked))
            if (std::ranges::find(settings.maps, map) == settings.maps.end()) settings.maps.push_back(map);
    }
    return settings;
}

}  // namespace job

std::vector<std::filesystem::path> filesOf(const Job& job, const View& view) {
    std::vector<std::filesystem::path> files;
    for (const std::string& output : job.outputs)
        for (auto& file : job::filesOfOutput(job, output, view)) files.push_back(std::move(file));
    if (!job.metadata.empty()) files.push_back(job::metadataFileOf(job, view));
    return files;
}

}  // namespace inkedge
