#include "sheet/title_block.h"

#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "settings/text.h"
#include "sheet/ink.h"
#include "sheet/page.h"
#include "sheet/symbol.h"

namespace inkedge::sheet {
namespace {

constexpr double captionHeight = 1.8;  // of letters, ISO 3098-1
constexpr double margin = 1.5;         // of a field's text to its sides
constexpr std::string_view cut = "...";

// A part of the block: what is in it, and its rectangle from the block's upper left corner.
struct Field {
    std::string_view caption;
    std::string value;
    Rect rect;
    double height;  // of the value's letters where they fit
};

std::vector<Field> fieldsOf(const Sheet& sheet) {
    return {{"TITLE", titleOf(sheet), {{0, 0}, {120, 12}}, 5.0},
            {"SCALE", settings::textOfScale(sheet.scale), {{150, 0}, {180, 12}}, 3.5},
            {"FILE", sheet.model, {{0, 12}, {85, 24}}, 3.5},
            {"DATE", sheet.settings.date, {{85, 12}, {120, 24}}, 3.5},
            {"SIZE", fmt::format("A{}", sheet.settings.page.series), {{120, 12}, {150, 24}}, 3.5},
            {"SHEET", "1/1", {{150, 12}, {180, 24}}, 3.5}};
}

constexpr Rect symbolRect{{120, 0}, {150, 12}};

// A value, the letters as large as they fit; what does not fit at all is cut.
struct Fitted {
    std::string text;
    double height;
    bool isCut = false;
};

Fitted fitted(const Field& field) {
    constexpr std::array heights{5.0, 3.5, 2.5, 1.8};  // ISO 3098-1
    const double room = field.rect.size().x - 2.0 * margin;
    for (const double height : heights) {
        if (height <= field.height && widthOf(field.value, height) <= room) return {field.value, height};
    }
    std::string text = field.value;
    while (!text.empty() && widthOf(text + std::string{cut}, heights.back()) > room) {
        text.pop_back();
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
        if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xC0U) text.pop_back();
    }
    return {text + std::string{cut}, heights.back(), true};
}

}  // namespace

std::string titleOf(const Sheet& sheet) {
    return sheet.settings.title.empty() ? std::filesystem::path{sheet.model}.stem().string() : sheet.settings.title;
}

std::vector<io::Layer> titleBlockLayers(const Sheet& sheet) {
    const double wide = wideLine(sheet.settings.page);
    const Rect block = titleBlock(sheet.settings.page);
    Ink lines{"title-block", 0.5 * wide};
    Ink words{"text", lineWidthOf(3.5)};
    const auto moved = [&](const Rect& rect) { return Rect{block.low + rect.low, block.low + rect.high}; };
    for (const Field& field : fieldsOf(sheet)) {
        const Rect rect = moved(field.rect);
        lines.rectangle(rect, 0.5 * wide);
        words.text(field.caption, rect.low + glm::dvec2{margin, 1.0 + captionHeight}, captionHeight);
        const Fitted value = fitted(field);
        if (!value.text.empty()) words.text(value.text, {rect.low.x + margin, rect.high.y - 2.0}, value.height);
    }
    lines.rectangle(block, wide);
    Ink symbol{"symbol", lineWidthOf(3.5)};
    drawSymbol(symbol, sheet.settings.projection, moved(symbolRect).middle(), 3.5);
    std::vector<io::Layer> layers;
    layers.push_back(std::move(lines).take());
    layers.push_back(std::move(symbol).take());
    layers.push_back(std::move(words).take());
    return layers;
}

std::vector<std::string> titleBlockWarnings(const Sheet& sheet) {
    std::vector<std::string> warnings;
    std::string unknown;
    for (const Field& field : fieldsOf(sheet)) {
        unknown += unknownIn(field.value);
        if (fitted(field).isCut)
            warnings.push_back(fmt::format("the title block has no room for '{}', which is cut", field.value));
    }
    if (!unknown.empty())
        warnings.push_back(fmt::format("the title block has no letters for {}, and shows boxes", unknownIn(unknown)));
    return warnings;
}

}  // namespace inkedge::sheet
