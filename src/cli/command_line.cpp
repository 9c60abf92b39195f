#include "cli/command_line.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <variant>

#include <inkedge/setting_table.h>

namespace inkedge::cli {
namespace {

// Of a form such as "COLOR|none" what is to be typed as it is: "none".
std::vector<std::string> wordsIn(std::string_view form) {
    std::vector<std::string> words;
    if (form.find('|') == std::string_view::npos) return words;
    while (!form.empty()) {
        const std::string_view word = form.substr(0, form.find('|'));
        form.remove_prefix(std::min(word.size() + 1, form.size()));
        const auto isWord = [](unsigned char c) { return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-'; };
        if (std::ranges::all_of(word, isWord)) words.emplace_back(word);
    }
    return words;
}

void addValues(OptionText& option) {
    option.values = wordsIn(option.form);
    const SettingDescription* const row = option.isPositional() ? nullptr : findSetting(option.name().substr(2));
    const List* const list = row == nullptr ? nullptr : std::get_if<List>(&row->constraint);
    if (list == nullptr || option.form != row->values()) return;
    option.values.assign(list->names.begin(), list->names.end());
    option.list = true;
}

OptionText textOf(const CLI::Option& option) {
    OptionText text;
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
    if (text.names.empty()) text.names.push_back(option.get_name());
    const bool isFlag = option.get_items_expected_max() == 0;
    if (!isFlag) text.form = option.get_type_name();
    text.repeats = option.get_expected_max() > 1;
    text.help = option.get_description();
    if (option.get_group() != "Options") text.group = option.get_group();
    addValues(text);
    return text;
}

}  // namespace

const std::string& OptionText::name() const {
    const auto isLong = [](const std::string& each) { return each.starts_with("--"); };
    const auto found = std::ranges::find_if(names, isLong);
    return found == names.end() ? names.front() : *found;
}

std::vector<VerbText> verbsOf(const CLI::App& app) {
    std::vector<VerbText> verbs;
    for (const CLI::App* verb : app.get_subcommands({})) {
        if (verb->get_group().empty()) continue;  // not for people
        VerbText& text = verbs.emplace_back(VerbText{verb->get_name(), verb->get_description(), {}});
        for (const CLI::Option* option : verb->get_options()) text.options.push_back(textOf(*option));
    }
    return verbs;
}

}  // namespace inkedge::cli
