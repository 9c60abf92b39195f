#include "cli/manual_page.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/version.h>

namespace inkedge::cli {
namespace {

// Text in which nothing is a command of roff's.
std::string plain(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string sentence(std::string_view help) { return plain(help) + (help.ends_with('.') ? "\n" : ".\n"); }

std::string entry(const OptionText& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(fmt::format("\\fB{}\\fR", plain(name)));
    const std::string form =
        option.form.empty() || option.isPositional() ? std::string{} : fmt::format(" \\fI{}\\fR", plain(option.form));
    return fmt::format(".TP\n{}{}\n{}", fmt::join(names, ", "), form, sentence(option.help));
}

std::string synopsis(const VerbText& verb) {
    std::string text = fmt::format(".br\n\\fBinkedge {}\\fR", verb.name);
    for (const OptionText& option : verb.options)
        if (option.isPositional()) text += fmt::format(" \\fI{}\\fR", plain(option.names.front()));
    return text + " [\\fIoptions\\fR]\n";
}

std::string section(const VerbText& verb) {
    std::string text = fmt::format(".SS inkedge {}\n{}", verb.name, sentence(verb.help));
    std::string group;
    for (const OptionText& option : verb.options) {
        if (option.group != group) {
            group = option.group;
            text += fmt::format(".PP\n\\fI{}\\fR\n", plain(group));
        }
        text += entry(option);
    }
    return text;
}

constexpr std::string_view ending = R"(.SH EXIT STATUS
.TP
0
Success.
.TP
1
A failure at run time, or what was compared differs.
.TP
2
A wrong command line or setting.
.TP
3
A model or another input that cannot be read.
.TP
4
No OpenGL context can be had.
.TP
5
An output that cannot be written.
.TP
129, 130, 143
Ended by SIGHUP, SIGINT or SIGTERM.
.SH ENVIRONMENT
Every setting may be given as a variable: \fBINKEDGE_LINE_WIDTH\fR for \fB\-\-line\-width\fR. An option overrides
a variable, a variable overrides the file of \fB\-\-config\fR, and that overrides \fB\-\-preset\fR.
.SH EXAMPLES
.EX
inkedge render part.step \-o part.svg
inkedge render model.glb \-o 'views/{view}.png' \-\-views turntable:12
inkedge sheet part.step \-o part.pdf
.EE
)";

}  // namespace

std::string manualPage(std::string_view summary, std::span<const VerbText> verbs) {
    std::string text = fmt::format(".TH INKEDGE 1 \"\" \"inkedge {}\" \"User Commands\"\n", version());
    const std::string_view withoutStop = summary.substr(0, summary.size() - (summary.ends_with('.') ? 1 : 0));
    text += fmt::format(".SH NAME\ninkedge \\- {}\n.SH SYNOPSIS\n", plain(withoutStop));
    for (const VerbText& verb : verbs) text += synopsis(verb);
    text += ".SH VERBS\n";
    for (const VerbText& verb : verbs) text += section(verb);
    return text + std::string{ending};
}

}  // namespace inkedge::cli
