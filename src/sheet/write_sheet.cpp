#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <inkedge/encode_png.h>
#include <inkedge/error.h>
#include <inkedge/sheet.h>
#include <inkedge/write_file.h>

#include "io/dxf.h"
#include "io/metadata.h"
#include "io/output_formats.h"
#include "io/pdf.h"
#include "io/svg.h"
#include "settings/lengths.h"
#include "settings/names.h"
#include "settings/text.h"
#include "sheet/border.h"
#include "sheet/ink.h"
#include "sheet/page.h"
#include "sheet/title_block.h"

namespace inkedge {
namespace sheet {
namespace {

std::string viewName(NamedView view) { return std::string{settings::namedViewNames[static_cast<std::size_t>(view)]}; }

std::string metadataOf(const Sheet& sheet) {
    const SheetSettings& settings = sheet.settings;
    io::Json views = io::Json::array();
    for (const SheetView& view : sheet.views) {
        views.push_back({{"view", viewName(view.view)},
                         {"middle", {view.middle.x, view.middle.y}},
                         {"size", {view.size.x, view.size.y}}});
    }
    const glm::dvec2 size = sizeOf(settings.page);
    const io::Json metadata{{"model", sheet.model},
                            {"page", nameOf(settings.page)},
                            {"size", {size.x, size.y}},
                            {"scale", settings::textOfScale(sheet.scale)},
                            {"projection", settings.projection == Projection::First ? "first" : "third"},
                            {"views", std::move(views)},
                            {"settings", io::settingsJson(sheet.drawn)}};
    return io::textOf(metadata, -1);
}

void add(io::Drawing& drawing, std::vector<io::Layer> layers) {
    drawing.layers.insert(drawing.layers.end(), std::make_move_iterator(layers.begin()),
                          std::make_move_iterator(layers.end()));
}

io::Drawing drawingOf(const Sheet& sheet) {
    const glm::dvec2 size = sizeOf(sheet.settings.page);
    io::Drawing drawing;
    drawing.page = {pixelsPerMillimetre * size, glm::dvec2{0.0}, pixelsPerMillimetre * settings::millimetresPerInch,
                    PageSize{size.x, size.y}};
    drawing.title = io::validText(titleOf(sheet));
    drawing.description =
        fmt::format("Drawing sheet {} at {}", nameOf(sheet.settings.page), settings::textOfScale(sheet.scale));
    drawing.metadata = metadataOf(sheet);
    drawing.background = sheet.drawn.picture.background;
    for (const SheetView& view : sheet.views) {
        const glm::dvec2 half = 0.5 * glm::dvec2{view.lines.size.width, view.lines.size.height};
        io::LineLayers drawn = io::layersOf(view.lines, sheet.drawn.picture, sheet.drawn.lines,
                                            io::VaryingWidths::Centres, pixelsPerMillimetre * view.middle - half);
        for (io::Layer& layer : drawn.layers) layer.view = viewName(view.view);
        add(drawing, std::move(drawn.layers));
    }
    if (!sheet.views.empty()) drawing.names = io::objectNames(sheet.views.front().lines.names);
    drawing.layers.push_back(borderLayer(sheet.settings.page));
    add(drawing, titleBlockLayers(sheet));
    drawing.step = 0.01;  // a thousandth of a millimetre
    return drawing;
}

Size pictureSize(const Sheet& sheet) {
    const glm::dvec2 pixels = sheet.dpi / settings::millimetresPerInch * sizeOf(sheet.settings.page);
    if (!(std::max(pixels.x, pixels.y) <= PictureSettings::maxSide && std::min(pixels.x, pixels.y) >= 1.0))
        throw Error{Error::Kind::Usage,
                    fmt::format("--dpi: expected a picture of 1 to {} pixels along each side, found "
                                "{:.0f} x {:.0f}",
                                PictureSettings::maxSide, pixels.x, pixels.y)};
    return {static_cast<int>(std::lround(pixels.x)), static_cast<int>(std::lround(pixels.y))};
}

}  // namespace
}  // namespace sheet

void expectSheetFile(const std::filesystem::path& file) {
    constexpr std::array<io::OutputFormat, 4> written{io::LinesFormat::Svg, io::LinesFormat::Pdf, io::LinesFormat::Dxf,
                                                      io::PictureFormat::Png};
    const auto format = io::outputFormat(file);
    if (format && std::ranges::find(written, *format) != written.end()) return;
    throw Error{Error::Kind::Usage,
                fmt::format("{}: expected a name that ends in .svg, .pdf, .dxf or .png, found {}", file.string(),
                            file.has_extension() ? file.extension().string() : "no extension")};
}

void writeSheet(const Sheet& sheet, const std::filesystem::path& file) {
    expectSheetFile(file);
    const io::Drawing drawing = sheet::drawingOf(sheet);
    const auto writeText = [&](const std::string& text) {
        writeFile(file, std::vector<std::uint8_t>(text.begin(), text.end()));
    };
    if (io::formatOf<io::PictureFormat>(file)) {
        const Image<std::uint8_t> picture = io::pictureOf(drawing, sheet::pictureSize(sheet));
        return writeFile(file, encodePng(picture, sheet.dpi));
    }
    switch (*io::formatOf<io::LinesFormat>(file)) {
        case io::LinesFormat::Svg:
            return writeText(io::svgOf(drawing));
        case io::LinesFormat::Pdf:
            return writeFile(file, io::pdfOf(drawing));
        case io::LinesFormat::Dxf:
            return writeText(io::dxfOf(drawing, 1.0 / sheet::pixelsPerMillimetre));
        case io::LinesFormat::LinesJson:
            break;
    }
}

}  // namespace inkedge
