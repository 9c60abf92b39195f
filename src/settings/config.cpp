#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "settings/rows.h"

namespace inkedge {
namespace {

constexpr std::size_t maximumFileBytes = std::size_t{1} << 20;
constexpr std::size_t maximumLineBytes = 4096;

[[noreturn]] void refuse(Error::Kind kind, const std::string& where, const std::string& message) {
    throw Error{kind, where + ": " + message};
}

// The content of a file, or of a pipe, which may have no end: so there is a limit.
std::string contentOf(const std::filesystem::path& file) {
    std::ifstream stream{file, std::ios::binary};
    stream.peek();  // fails for a folder, which can be opened but not read
    if (stream.fail() && !stream.eof())
        refuse(Error::Kind::Input, file.string(), "expected a configuration file, found none that can be read");
    std::string content(maximumFileBytes + 1, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(stream.gcount()));
    if (content.size() > maximumFileBytes)
        refuse(Error::Kind::Input, file.string(),
               fmt::format("expected a configuration file of at most {} bytes, found more", maximumFileBytes));
    return content;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view unquoted(std::string_view text) {
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

// A comment is a line that starts with #, because a colour may start with one too.
void readLine(Settings& settings, std::string_view line, const std::string& where) {
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') return;
    if (text.size() > maximumLineBytes)
        refuse(Error::Kind::Usage, where,
               fmt::format("expected lines of at most {} bytes, found {}", maximumLineBytes, text.size()));
    const auto isControl = [](char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f; };
    if (const auto* control = std::ranges::find_if(text, isControl); control != text.end())
        refuse(Error::Kind::Usage, where, fmt::format("expected text, found the control character {}", int{*control}));
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
        refuse(Error::Kind::Usage, where, fmt::format("expected name = value, found '{}'", text));
    const std::string_view name = trimmed(text.substr(0, equals));
    if (findSetting(name) == nullptr)
        refuse(Error::Kind::Usage, where,
               fmt::format("expected the name of a setting, found '{}'{}", name, settings::suggestSetting(name)));
    set(settings, name, unquoted(trimmed(text.substr(equals + 1))), fmt::format("{}: {}", where, name));
}

}  // namespace

std::string configText(const Settings& settings) {
    std::string text;
    const Settings defaults;
    for (const SettingDescription& row : settingTable()) {
        const std::string value = row.get(settings);
        if (value != row.get(defaults)) text += fmt::format("{} = {}\n", row.name, value);
    }
    return text;
}

void readConfig(Settings& settings, const std::filesystem::path& file) {
    std::istringstream lines{contentOf(file)};
    int number = 1;
    for (std::string line; std::getline(lines, line); ++number)
        readLine(settings, line, fmt::format("{}:{}", file.string(), number));
}

}  // namespace inkedge
