// The README's tables of settings and presets and its list of formats are written from their tables, so that they
// cannot go stale. With INKEDGE_UPDATE_README set (tools/update_readme) the tests write them instead of comparing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/load_scene.h>
#include <inkedge/setting_table.h>
#include <inkedge/sheet.h>

namespace inkedge {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string{"\\|"} : std::string{c};
    return result;
}

std::string settingsTable() {
    std::string table = "| Flag | Values | Default | Meaning |\n| --- | --- | --- | --- |\n";
    for (const SettingDescription& row : settingTable()) {
        std::string flags = fmt::format("`--{}`", row.name);
        if (!row.shortName.empty()) flags += fmt::format(", `--{}`", row.shortName);
        table += fmt::format("| {} | `{}`: {} | {} | {} |\n", flags, escaped(row.values()), escaped(row.range()),
                             escaped(row.defaultValue()), escaped(row.help));
    }
    return table;
}

std::string formatsList() {
    std::vector<std::string> items;
    for (const ModelFormat& format : readableFormats())
        items.push_back(fmt::format("{} (`{}`)", format.name, fmt::join(format.extensions, "`, `")));
    const std::string last = items.back();
    items.pop_back();
    return fmt::format("{} or {}", fmt::join(items, ", "), last);
}

// Compares what stands between two marks with what should, or writes it.
void expectBetween(const std::string& begin, const std::string& end, const std::string& expected) {
    const std::string file = INKEDGE_SOURCE_DIR "/README.md";
    std::ostringstream stream;
    stream << std::ifstream{file}.rdbuf();
    const std::string readme = stream.str();
    const std::size_t beginAt = readme.find(begin);
    const std::size_t endAt = readme.find(end);
    ASSERT_NE(beginAt, std::string::npos) << "README.md has no " << begin;
    ASSERT_NE(endAt, std::string::npos) << "README.md has no " << end;
    const std::size_t start = beginAt + begin.size();

    if (std::getenv("INKEDGE_UPDATE_README") != nullptr) {
        std::ofstream{file} << readme.substr(0, start) << expected << readme.substr(endAt);
        return;
    }
    EXPECT_EQ(readme.substr(start, endAt - start), expected) << "run tools/update_readme";
}

TEST(Readme, settingsTableIsTheSettingsTable) {
    expectBetween("<!-- settings -->\n", "<!-- /settings -->", settingsTable());
}

TEST(Readme, presetsAreThePresets) {
    std::string table = "| Name | For | Settings |\n| --- | --- | --- |\n";
    for (const Preset& preset : presets()) {
        std::vector<std::string> settings;
        for (const auto& [name, text] : preset.values) settings.push_back(fmt::format("`--{} {}`", name, text));
        table += fmt::format("| `{}` | {} | {} |\n", preset.name, preset.help, fmt::join(settings, ", "));
    }
    expectBetween("<!-- presets -->\n", "<!-- /presets -->", table);
}

TEST(Readme, sheetOptionsAreTheSheetOptions) {
    std::string table = "| Flag | Default | Meaning |\n| --- | --- | --- |\n";
    for (const SheetOption& option : sheetOptions())
        table += fmt::format("| `--{} {}` | {} | {} |\n", option.name, escaped(option.values), option.byDefault,
                             escaped(option.help));
    expectBetween("<!-- sheet -->\n", "<!-- /sheet -->", table);
}

TEST(Readme, formatsAreThoseOfTheTableOfReaders) {
    expectBetween("<!-- formats -->", "<!-- /formats -->", formatsList());
}

}  // namespace
}  // namespace inkedge
