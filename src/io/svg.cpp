#include "io/svg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <inkedge/write.h>

#include "io/metadata.h"
#include "io/svg_image.h"
#include "io/svg_path.h"

namespace inkedge {
namespace io {
namespace {

// A number with at most three decimals, rounded.
std::string number(double value) {
    std::string text = fmt::format("{:.3f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

// A length with at most three decimals, rounded down: a pixel that is only begun counts as one in librsvg.
std::string millimetres(double length) {
    constexpr double noise = 1e-6;  // of a thousandth: 20 is not 19.999 for being 19.99999999999
    return number(std::floor(length * 1000.0 + noise) / 1000.0) + "mm";
}

std::string hex(Color color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }

// Text for XML 1.0: UTF-8 without the characters that no document may have, markup as entities.
std::string escaped(std::string_view text) {
    std::string valid = validText(text);
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {  // U+FFFE, U+FFFF
        for (std::size_t at = 0; (at = valid.find(none, at)) != std::string::npos;)
            valid.replace(at, 3, "\xEF\xBF\xBD");
    }
    std::string result;
    for (const char c : valid) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
        }
    }
    return result;
}

// The same for the value of an attribute.
std::string attributeValue(std::string_view text) {
    std::string value = escaped(text);
    for (std::size_t at = 0; (at = value.find('"', at)) != std::string::npos;) value.replace(at, 1, "&quot;");
    return '"' + value + '"';
}

// The size and the coordinates of the document. They are of one shape: not all readers know preserveAspectRatio.
std::string documentSize(const Page& page) {
    const std::string viewBox = fmt::format("viewBox=\"0 0 {} {}\"", number(page.size.x), number(page.size.y));
    if (!page.paper)
        return fmt::format("width=\"{}\" height=\"{}\" {}", number(page.size.x), number(page.size.y), viewBox);
    return fmt::format("width=\"{}\" height=\"{}\" {}", millimetres(page.paper->width), millimetres(page.paper->height),
                       viewBox);
}

bool isMoved(glm::dvec2 origin) {
    return std::max(std::abs(origin.x), std::abs(origin.y)) >= 0.001;  // the last decimal
}

std::string transformTo(glm::dvec2 origin) {
    return isMoved(origin) ? fmt::format(" transform=\"translate({} {})\"", number(origin.x), number(origin.y)) : "";
}

std::string inkOf(const Layer& layer) {
    if (layer.filled) return fmt::format("fill=\"{}\"", hex(layer.color));
    std::string ink = fmt::format("stroke=\"{}\" stroke-width=\"{}\"", hex(layer.color), number(layer.width));
    if (layer.dash > 0.0) ink += fmt::format(" stroke-dasharray=\"{} {}\"", number(layer.dash), number(layer.gap));
    return ink;
}

std::string attributesOf(const DrawnPath& drawn, const Layer& layer, const Drawing& drawing) {
    std::string text;
    if (drawn.object) {
        text += fmt::format(" data-object=\"{}\"", *drawn.object);
        const auto known = drawing.names.find(*drawn.object);
        if (known != drawing.names.end()) text += " data-name=" + attributeValue(known->second);
    }
    if (drawn.width != layer.width && !layer.filled) text += fmt::format(" stroke-width=\"{}\"", number(drawn.width));
    return text;
}

// A group is a layer of Inkscape's, and of the DXF files that it writes. The class of type and visibility together is
// for style sheets: LibreOffice reads selectors of one class alone.
std::string group(const Layer& layer, const Drawing& drawing, bool clips) {
    std::string attributes = transformTo(layer.origin);
    if (clips && isMoved(layer.origin)) attributes += " clip-path=\"url(#picture)\"";
    if (!layer.view.empty()) attributes += " data-view=" + attributeValue(layer.view);
    std::string text = fmt::format("<g class=\"inkedge {}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\" {}{}>\n",
                                   layer.classes, layer.name, inkOf(layer), attributes);
    for (const DrawnPath& drawn : layer.paths) {
        SvgPath path{drawing.step < 0.1 ? SvgPath::Step::Hundredth : SvgPath::Step::Tenth};
        drawn.path.copyTo(path);
        const std::string own = attributesOf(drawn, layer, drawing);
        for (const std::string& data : path.texts()) text += fmt::format("<path{} d=\"{}\"/>\n", own, data);
    }
    return text + "</g>\n";
}

std::string heading(const Drawing& drawing) {
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" {}{} "
        "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{}</title>\n"
        "<desc>{}</desc>\n<metadata>{}</metadata>\n",
        drawing.images.empty() ? "" : "xmlns:xlink=\"http://www.w3.org/1999/xlink\" ", documentSize(drawing.page),
        escaped(drawing.title), escaped(drawing.description), escaped(drawing.metadata));
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
    std::string text = heading(drawing);
    if (drawing.background) {
        text += fmt::format("<rect class=\"inkedge background\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                            number(drawing.page.size.x), number(drawing.page.size.y), hex(*drawing.background));
    }
    for (const DrawnImage& image : drawing.images) text += svgImage(*image.pixels, transformTo(image.origin));
    // Margins would show what lies beyond the picture's edges; without them the document's edges are the picture's.
    const bool clips = drawing.window && isMoved(drawing.page.picture);
    if (clips) {
        text += fmt::format("<clipPath id=\"picture\"><rect width=\"{}\" height=\"{}\"/></clipPath>\n",
                            drawing.window->width, drawing.window->height);
    }
    for (const Layer& layer : drawing.layers) text += group(layer, drawing, clips);
    return text + "</svg>\n";
}

}  // namespace io

std::string linesSvg(const Lines& lines, const Settings& settings, std::string_view title) {
    return io::svgOf(io::drawingOf(lines, settings, title, io::VaryingWidths::Outlines));
}

}  // namespace inkedge
