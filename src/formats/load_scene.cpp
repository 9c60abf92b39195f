#include <inkedge/load_scene.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "base/file_extension.h"
#include "base/message.h"
#include "base/read_file.h"
#include "formats/reader.h"

namespace inkedge {
namespace formats {
namespace {

namespace fs = std::filesystem;

std::string allExtensions() {
    std::vector<std::string_view> all;
    for (const Reader& reader : readers())
        all.insert(all.end(), reader.format.extensions.begin(), reader.format.extensions.end());
    const std::string_view last = all.back();
    all.pop_back();
    return fmt::format("{} or {}", fmt::join(all, ", "), last);
}

const Reader* byExtension(std::string_view extension) {
    for (const Reader& reader : readers())
        if (std::ranges::find(reader.format.extensions, extension) != reader.format.extensions.end()) return &reader;
    return nullptr;
}

const Reader* byFirstBytes(std::string_view start) {
    for (const Reader& reader : readers())
        if (std::ranges::any_of(reader.firstBytes, [&](std::string_view first) { return start.starts_with(first); }))
            return &reader;
    return nullptr;
}

const Reader& readerOf(const ModelInput& input) {
    const std::string extension = base::lowerCaseExtension(input.name);
    const Reader* const named = byExtension(extension);
    const base::Bytes bytes = base::within(input.where(), [&] { return startOf(input, 512); });
    const Reader* const known = byFirstBytes(base::textOf(bytes));
    if (known != nullptr && (named == nullptr || known->firstBytesAreCertain)) return *known;
    if (named != nullptr) return *named;
    base::refuse(fmt::format("{}: expected a model by its extension, {}, found {} with {}{}", input.where(),
                             allExtensions(), base::kindOf(base::textOf(bytes)),
                             extension.empty() ? "none" : base::printable(extension),
                             input.isFile() ? "" : "; say which it is: --format, or a name in the library"));
}

// What only some formats have to choose from.
void expectChoices(const SceneSource& source, const LoadSettings& settings) {
    const auto refuse = [&](std::string_view flag, std::string_view of, const std::string& found) {
        throw Error{Error::Kind::Usage, fmt::format("--{}: expected {} of the file, found '{}' for {}, which has none",
                                                    flag, of, found, source.format)};
    };
    if (settings.scene && source.scenes.empty()) refuse("scene", "a scene", fmt::format("{}", *settings.scene));
    if (!settings.animation.empty() && source.animations.empty())
        refuse("animation", "an animation", base::printable(settings.animation));
}

Scene load(const ModelInput& input, const LoadSettings& settings) {
    validate(settings);
    Scene::Data data = readModel(input, settings);
    return base::within(input.where(), [&] { return Scene{std::move(data), settings}; });
}

}  // namespace

Scene::Data readModel(const ModelInput& input, const LoadSettings& settings) {
    const Reader& reader = readerOf(input);
    Scene::Data data = reader.read(input, settings);
    for (std::string& warning : data.warnings) warning = base::printable(warning);
    data.source.name = input.name.filename().string();
    data.source.format = reader.format.name;
    data.source.knowsSides = reader.knowsSides;
    data.source.up = reader.up;
    if (data.source.unit == LengthUnit::None) data.source.unit = reader.unit;
    if (settings.unit != LengthUnit::None) data.source.unit = settings.unit;
    expectChoices(data.source, settings);
    return data;
}

}  // namespace formats

Scene loadScene(const std::filesystem::path& file, const LoadSettings& settings) {
    return formats::load({file}, settings);
}

Scene loadScene(std::span<const std::uint8_t> bytes, const std::filesystem::path& name, const LoadSettings& settings) {
    return formats::load({name, bytes}, settings);
}

}  // namespace inkedge
