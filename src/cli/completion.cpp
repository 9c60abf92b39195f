#include "cli/completion.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace inkedge::cli {
namespace {

// With a backslash before each of some characters.
std::string escaped(std::string_view text, std::string_view characters) {
    std::string result;
    for (const char c : text) {
        if (characters.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

// Between single quotes.
std::string inQuotes(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return result + "'";
}

std::string namesOf(std::span<const VerbText> verbs) {
    std::string names;
    for (const VerbText& verb : verbs) names += (names.empty() ? "" : " ") + verb.name;
    return names;
}

std::string bashOptions(const VerbText& verb) {
    std::string names;
    for (const OptionText& option : verb.options)
        if (!option.isPositional()) names += (names.empty() ? "" : " ") + option.name();
    return names;
}

// What is completed after options of one kind, as branches of a case.
std::string bashBranches(const VerbText& verb) {
    std::string branches;
    for (const OptionText& option : verb.options) {
        if (option.isPositional() || option.form.empty()) continue;
        const std::string action = option.takesFile() ? "_inkedge_files; return"
                                   : option.values.empty()
                                       ? "return"
                                       : fmt::format("values='{}'{}", fmt::join(option.values, " "),
                                                     option.list ? "; head=\"${word%\"${word##*,}\"}\"" : "");
        branches += fmt::format("        {}) {} ;;\n", fmt::join(option.names, "|"), action);
    }
    return branches;
}

// @param position  counts the positionals, from 1
std::string zshArgument(const OptionText& option, std::size_t position) {
    if (option.isPositional()) {
        const std::string where = option.repeats ? "*" : fmt::format("{}", position);
        return fmt::format("{}:{}:{}", where, option.names.front(),
                           option.values.empty() ? "_files" : fmt::format("({})", fmt::join(option.values, " ")));
    }
    const std::string help = escaped(option.help, "[]:\\");
    std::string value;
    if (!option.form.empty()) {
        const std::string action = option.takesFile()      ? "_files"
                                   : option.values.empty() ? " "
                                   : option.list ? fmt::format("_values -s , value {}", fmt::join(option.values, " "))
                                                 : fmt::format("({})", fmt::join(option.values, " "));
        value = fmt::format(":{}:{}", escaped(option.form, ":\\"), action);
    }
    return fmt::format("{}[{}]{}", option.name(), help, value);
}

std::string fishOption(const VerbText& verb, const OptionText& option) {
    std::string line = fmt::format("complete -c inkedge -n '__fish_seen_subcommand_from {}'", verb.name);
    for (const std::string& name : option.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.takesFile())
        line += " -r -F";
    else if (!option.form.empty())
        line += " -x";
    if (!option.values.empty()) line += fmt::format(" -a '{}'", fmt::join(option.values, " "));
    return fmt::format("{} -d {}\n", line, inQuotes(option.help));
}

}  // namespace

std::string bashCompletion(std::span<const VerbText> verbs) {
    std::string branches;
    for (const VerbText& verb : verbs) {
        std::string positional;
        for (const OptionText& option : verb.options)
            if (option.isPositional() && !option.values.empty())
                positional = fmt::format("{}", fmt::join(option.values, " "));
        branches +=
            fmt::format("    {}) options='{}'; positional='{}'\n        case \"$before\" in\n{}        esac ;;\n",
                        verb.name, bashOptions(verb), positional, bashBranches(verb));
    }
    return fmt::format(R"(# bash completion of inkedge
_inkedge_files() {{ mapfile -t COMPREPLY < <(compgen -f -- "$word"); }}
_inkedge() {{
    local word="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}"
    local options='' values='' positional='' head=''
    if [ "$word" = = ]; then
        word=''
    elif [ "$before" = = ]; then
        before="${{COMP_WORDS[COMP_CWORD-2]}}"
    fi
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W '{} --help --version' -- "$word"))
        return
    fi
    case "${{COMP_WORDS[1]}}" in
{}    *) return ;;
    esac
    if [ -n "$values" ]; then
        COMPREPLY=($(compgen -P "$head" -W "$values" -- "${{word##*,}}"))
    elif [[ "$word" == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    elif [ -n "$positional" ]; then
        COMPREPLY=($(compgen -W "$positional" -- "$word"))
    else
        _inkedge_files
    fi
}}
complete -o filenames -F _inkedge inkedge
)",
                       namesOf(verbs), branches);
}

std::string zshCompletion(std::span<const VerbText> verbs) {
    std::string names;
    std::string branches;
    for (const VerbText& verb : verbs) {
        names += fmt::format(" {}", inQuotes(verb.name + ":" + escaped(verb.help, ":\\")));
        branches += fmt::format("    {})\n        _arguments", verb.name);
        std::size_t position = 0;
        for (const OptionText& option : verb.options)
            branches += " \\\n            " + inQuotes(zshArgument(option, position += option.isPositional() ? 1 : 0));
        branches += "\n        ;;\n";
    }
    return fmt::format(R"(#compdef inkedge
_inkedge() {{
    local -a verbs=({})
    local context state line
    _arguments -C '1: :->verb' '*:: :->arguments'
    case $state in
    verb) _describe verb verbs; return ;;
    esac
    case $words[1] in
{}    esac
}}
_inkedge "$@"
)",
                       names, branches);
}

std::string fishCompletion(std::span<const VerbText> verbs) {
    std::string text = "# fish completion of inkedge\n";
    for (const VerbText& verb : verbs)
        text += fmt::format("complete -c inkedge -f -n __fish_use_subcommand -a {} -d {}\n", verb.name,
                            inQuotes(verb.help));
    for (const VerbText& verb : verbs) {
        for (const OptionText& option : verb.options) {
            if (!option.isPositional())
                text += fishOption(verb, option);
            else if (!option.values.empty())
                text += fmt::format("complete -c inkedge -f -n '__fish_seen_subcommand_from {}' -a '{}'\n", verb.name,
                                    fmt::join(option.values, " "));
        }
    }
    return text;
}

}  // namespace inkedge::cli
