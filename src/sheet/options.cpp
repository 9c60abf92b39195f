#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>
#include <inkedge/sheet.h>

#include "base/nearest_name.h"
#include "settings/names.h"
#include "settings/text.h"
#include "sheet/page.h"

namespace inkedge {
namespace sheet {
namespace {

using settings::Expected;

constexpr std::array<std::string_view, 2> projectionNames{"first", "third"};
constexpr std::array<std::string_view, 3> hiddenNames{"none", "dashed", "solid"};

// Turns what a parser expected into an error that names the option.
template <class Parse>
void parsed(std::string_view name, std::string_view text, Parse parse) {
    try {
        parse();
    } catch (const Expected& expected) {
        throw Error{Error::Kind::Usage,
                    fmt::format("--{}: expected {}, found '{}'{}", name, expected.what, text, expected.remedy)};
    }
}

std::vector<NamedView> viewsOf(std::string_view text) {
    std::vector<NamedView> views;
    for (const std::string_view name : settings::split(text, ',')) {
        const auto* const found = std::ranges::find(settings::namedViewNames, name);
        if (found == settings::namedViewNames.end())
            throw Expected{fmt::format("{}, with commas between them", fmt::join(settings::namedViewNames, ", ")),
                           base::suggestion(name, settings::namedViewNames)};
        const auto view = static_cast<NamedView>(found - settings::namedViewNames.begin());
        if (std::ranges::find(views, view) != views.end()) throw Expected{"each view once"};
        views.push_back(view);
    }
    return views;
}

SheetPage pageOf(std::string_view text) {
    constexpr std::string_view lying = "-landscape";
    constexpr std::string_view standing = "-portrait";
    const std::string_view series = text.substr(0, 2);
    if (series.size() < 2 || (series[0] != 'A' && series[0] != 'a') || series[1] < '0' || series[1] > '4')
        throw Expected{"A4, A3, A2, A1 or A0, with -landscape or -portrait"};
    SheetPage page = pageOfSeries(series[1] - '0');
    const std::string_view rest = text.substr(2);
    if (!rest.empty() && rest != lying && rest != standing)
        throw Expected{"A4, A3, A2, A1 or A0, with -landscape or -portrait"};
    if (!rest.empty()) page.landscape = rest == lying;
    return page;
}

constexpr std::array options{
    SheetOption{"projection", "first|third",
                "on which side of the front view another one lies: first: beyond the part, as in Europe; third: on the "
                "side that it is seen from, as in America",
                "first",
                [](SheetSettings& s, std::string_view text) {
                    parsed("projection", text, [&] {
                        s.projection = static_cast<Projection>(settings::parseChoice(projectionNames, text));
                    });
                }},
    SheetOption{
        "views", "VIEW,...",
        "the views: front, back, left, right, top and bottom, aligned with each other; iso and dimetric, where "
        "room is left",
        "front,top,right,iso",
        [](SheetSettings& s, std::string_view text) { parsed("views", text, [&] { s.views = viewsOf(text); }); }},
    SheetOption{"page", "A4|...|A0", "the page; -landscape or -portrait after its name turns it", "A3",
                [](SheetSettings& s, std::string_view text) { parsed("page", text, [&] { s.page = pageOf(text); }); }},
    SheetOption{
        "scale", "auto|PAPER:MODEL",
        "of all views; auto: the largest of 1:1, 1:2, 1:5, 1:10, ..., 2:1, 5:1, ... that fits on the page", "auto",
        [](SheetSettings& s, std::string_view text) {
            parsed("scale", text,
                   [&] { s.scale = text == "auto" ? std::nullopt : std::optional{settings::parseScale(text)}; });
        }},
    SheetOption{"hidden", "none|dashed|solid", "how hidden lines are drawn; iso and dimetric have none", "dashed",
                [](SheetSettings& s, std::string_view text) {
                    parsed("hidden", text,
                           [&] { s.hidden = static_cast<HiddenLines>(settings::parseChoice(hiddenNames, text)); });
                }},
    SheetOption{"title", "TEXT", "for the title block", "the model's name",
                [](SheetSettings& s, std::string_view text) { s.title = text; }},
    SheetOption{"date", "TEXT", "for the title block, as it is", "",
                [](SheetSettings& s, std::string_view text) { s.date = text; }}};

}  // namespace
}  // namespace sheet

std::span<const SheetOption> sheetOptions() noexcept { return sheet::options; }

}  // namespace inkedge
