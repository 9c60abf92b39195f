#include "tune/request.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include <inkedge/error.h>

#include "io/parse_json.h"
#include "tune/texts.h"

namespace inkedge::tune {
namespace {

// No name leads anywhere, for nothing is written.
void expectKnownOutput(const std::string& output) {
    constexpr std::array<std::string_view, 5> known{"drawing.png", "drawing.svg", "drawing.pdf", "drawing.dxf",
                                                    "drawing.json"};
    if (std::ranges::find(known, output) == known.end())
        throw Error{Error::Kind::Usage, "output: expected drawing.png, .svg, .pdf, .dxf or .json, found another"};
}

}  // namespace

Request requestOf(const std::string& body) {
    try {
        const io::ParsedJson json = io::parseJson(body, {"", {}}, {.depth = 4, .values = 4096});
        std::map<std::string, std::string> texts;
        for (const auto& [name, text] : json.at("settings").items()) texts[name] = text.get<std::string>();
        Request request;
        request.tab = json.value("tab", "");
        request.number = json.value("number", std::uint64_t{0});
        request.settings = settingsOf(texts);
        if (json.value("before", false)) request.work = Work::Before;
        if (json.value("half", false)) request.detail = Detail::Half;
        request.output = json.value("output", request.output);
        request.x = json.value("x", 0);
        request.y = json.value("y", 0);
        expectKnownOutput(request.output);
        return request;
    } catch (const io::ParsedJson::exception&) {
        throw Error{Error::Kind::Input, "request: expected what the page of inkedge tune asks for, found another JSON"};
    }
}

}  // namespace inkedge::tune
