#include <inkedge/compare_lines.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <inkedge/encode_png.h>
#include <inkedge/error.h>
#include <inkedge/settings.h>
#include <inkedge/write_file.h>

#include "base/file_key.h"
#include "io/drawing.h"
#include "io/metadata.h"
#include "io/output_formats.h"
#include "io/pdf.h"
#include "io/svg.h"

namespace inkedge {
namespace {

// Okabe and Ito 2008: told apart by all eyes.
constexpr Color vermilion{0xd5, 0x5e, 0x00};
constexpr Color blue{0x00, 0x72, 0xb2};
constexpr Color purple{0xaa, 0x33, 0x99};
constexpr Color grey{0xbb, 0xbb, 0xbb};

void addTo(io::Layer& layer, const std::vector<ComparedLine>& lines) {
    for (const ComparedLine& line : lines) {
        io::Path path;
        path.moveTo(line.points.front());
        for (std::size_t i = 1; i < line.points.size(); ++i) path.lineTo(line.points[i]);
        if (line.closed) path.close();
        layer.paths.push_back({std::move(path), layer.width, line.object});
    }
}

io::Layer layerOf(std::string name, Color color, double width) {
    io::Layer layer;
    layer.classes = name;
    layer.name = std::move(name);
    layer.color = color;
    layer.width = width;
    return layer;
}

std::vector<io::Layer> layersOf(const LinesComparison& comparison) {
    constexpr double fine = 1.0;  // pixels
    constexpr double wide = 2.5;
    io::Layer unchanged = layerOf("unchanged", grey, fine);
    io::Layer before = layerOf("before", purple, fine);
    io::Layer vanished = layerOf("vanished", vermilion, wide);
    io::Layer appeared = layerOf("appeared", blue, wide);
    io::Layer changed = layerOf("changed", purple, wide);
    before.dash = 4.0;
    before.gap = 4.0;
    addTo(unchanged, comparison.unchanged);
    for (const LineChange& change : comparison.changes) {
        if (change.kind == LineChangeKind::Moved) addTo(before, change.before);
        if (change.kind == LineChangeKind::Vanished) addTo(vanished, change.before);
        addTo(change.kind == LineChangeKind::Appeared ? appeared : changed, change.after);
    }
    std::vector<io::Layer> layers;
    for (io::Layer* layer : {&unchanged, &before, &vanished, &appeared, &changed})
        if (!layer->paths.empty()) layers.push_back(std::move(*layer));
    return layers;
}

std::string headingOf(const LinesComparison& comparison) {
    const std::string text = comparisonText(comparison);
    return text.substr(0, text.find('\n'));
}

io::Drawing drawingOf(const LinesComparison& comparison) {
    io::Drawing drawing;
    drawing.page.size = {comparison.size.width, comparison.size.height};
    drawing.page.dpi = 96.0;
    drawing.title = "Changes of lines";
    drawing.description = headingOf(comparison);
    drawing.metadata = "{}";
    drawing.background = Color{255, 255, 255};
    drawing.layers = layersOf(comparison);
    drawing.window = comparison.size;
    return drawing;
}

}  // namespace

void expectComparisonFile(const std::filesystem::path& file, std::span<const std::filesystem::path> inputs) {
    constexpr std::array<io::OutputFormat, 3> written{io::LinesFormat::Svg, io::LinesFormat::Pdf,
                                                      io::PictureFormat::Png};
    const auto format = io::outputFormat(file);
    if (!format || std::ranges::find(written, *format) == written.end())
        throw Error{Error::Kind::Usage,
                    fmt::format("{}: expected a name that ends in .svg, .pdf or .png, found {}", file.string(),
                                file.has_extension() ? file.extension().string() : "no extension")};
    for (const std::filesystem::path& input : inputs) {
        if (base::fileKey(file) != base::fileKey(input)) continue;
        throw Error{Error::Kind::Usage,
                    fmt::format("{}: expected an output other than what is compared, found {}; choose another name",
                                file.string(), input.string())};
    }
}

void writeComparison(const LinesComparison& comparison, const std::filesystem::path& file) {
    expectComparisonFile(file, {});
    const io::Drawing drawing = drawingOf(comparison);
    if (io::formatOf<io::PictureFormat>(file))
        return writeFile(file, encodePng(io::pictureOf(drawing, comparison.size)));
    if (io::formatOf<io::LinesFormat>(file) == io::LinesFormat::Pdf) return writeFile(file, io::pdfOf(drawing));
    const std::string text = io::svgOf(drawing);
    writeFile(file, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace inkedge
