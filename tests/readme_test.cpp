// The README's table of settings is written from the settings table, so that it cannot go stale. With
// INKEDGE_UPDATE_README set (tools/update_readme) the test writes it instead of comparing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include <inkedge/setting_table.h>

namespace inkedge {
namespace {

constexpr std::string_view tableBegin = "<!-- settings -->\n";
constexpr std::string_view tableEnd = "<!-- /settings -->";

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

TEST(Readme, settingsTableIsTheSettingsTable) {
    const std::string file = INKEDGE_SOURCE_DIR "/README.md";
    std::ostringstream stream;
    stream << std::ifstream{file}.rdbuf();
    const std::string readme = stream.str();
    const std::size_t begin = readme.find(tableBegin);
    const std::size_t end = readme.find(tableEnd);
    ASSERT_NE(begin, std::string::npos) << "README.md has no line " << tableBegin;
    ASSERT_NE(end, std::string::npos) << "README.md has no line " << tableEnd;
    const std::size_t tableStart = begin + tableBegin.size();

    if (std::getenv("INKEDGE_UPDATE_README") != nullptr) {
        std::ofstream{file} << readme.substr(0, tableStart) << settingsTable() << readme.substr(end);
        return;
    }
    EXPECT_EQ(readme.substr(tableStart, end - tableStart), settingsTable()) << "run tools/update_readme";
}

}  // namespace
}  // namespace inkedge
