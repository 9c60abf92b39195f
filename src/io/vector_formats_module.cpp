// PDF and pictures by Cairo.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include <cairo-pdf.h>
#include <cairo.h>
#include <glm/geometric.hpp>

#include <inkedge/export.h>

#include "io/vector_formats.h"
#include "modules/failure.h"

namespace inkedge::io {
namespace {

constexpr double pointsPerInch = 72.0;
constexpr double millimetresPerInch = 25.4;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
    auto& all = *static_cast<std::vector<std::uint8_t>*>(to);
    try {
        all.insert(all.end(), bytes, bytes + count);
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
    return CAIRO_STATUS_SUCCESS;
}

// A path as Cairo takes it.
class CairoPath {
public:
    explicit CairoPath(cairo_t* context) : context_{context} {}
    void moveTo(glm::dvec2 to) {
        cairo_move_to(context_, to.x, to.y);
        start_ = at_ = to;
    }
    void lineTo(glm::dvec2 to) {
        cairo_line_to(context_, to.x, to.y);
        at_ = to;
    }
    void curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 to) {
        cairo_curve_to(context_, control1.x, control1.y, control2.x, control2.y, to.x, to.y);
        at_ = to;
    }
    void arcTo(double radius, glm::dvec2 to) {
        const glm::dvec2 chord = to - at_;
        const double half = 0.5 * glm::length(chord);
        if (half == 0.0) return;
        const double reach = std::max(radius, half);
        const double off = std::sqrt(reach * reach - half * half);
        const glm::dvec2 centre = 0.5 * (at_ + to) + off * glm::dvec2{-chord.y, chord.x} / (2.0 * half);
        const auto angle = [&](glm::dvec2 p) { return std::atan2(p.y - centre.y, p.x - centre.x); };
        cairo_arc(context_, centre.x, centre.y, reach, angle(at_), angle(to));
        at_ = to;
    }
    void close() {
        cairo_close_path(context_);
        at_ = start_;
    }

private:
    cairo_t* context_;
    glm::dvec2 start_{0.0};
    glm::dvec2 at_{0.0};
};

void setColor(cairo_t* context, Color color) {
    cairo_set_source_rgb(context, color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

// The pixels of a picture as Cairo has them, premultiplied; the surface refers to them.
std::vector<std::uint32_t> premultiplied(const Image<std::uint8_t>& picture) {
    std::vector<std::uint32_t> pixels;
    const Size size = picture.size();
    pixels.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const std::uint32_t alpha = picture.channels() == 4 ? picture(x, y, 3) : 255U;
            std::uint32_t pixel = alpha;
            for (int c = 0; c < 3; ++c)
                pixel = pixel << 8U | (picture(x, y, picture.channels() < 3 ? 0 : c) * alpha + 127U) / 255U;
            pixels.push_back(pixel);
        }
    }
    return pixels;
}

void draw(cairo_t* context, const DrawnImage& image) {
    std::vector<std::uint32_t> pixels = premultiplied(*image.pixels);
    const Size size = image.pixels->size();
    const Surface surface{cairo_image_surface_create_for_data(
                              reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_ARGB32, size.width,
                              size.height, cairo_format_stride_for_width(CAIRO_FORMAT_ARGB32, size.width)),
                          cairo_surface_destroy};
    cairo_set_source_surface(context, surface.get(), image.origin.x, image.origin.y);
    cairo_paint(context);
    cairo_set_source_rgb(context, 0.0, 0.0, 0.0);
    cairo_surface_finish(surface.get());  // a PDF's surface has taken a copy
}

void draw(cairo_t* context, const Layer& layer, const std::optional<Size>& window) {
    cairo_save(context);
    cairo_translate(context, layer.origin.x, layer.origin.y);
    if (window) {
        cairo_rectangle(context, 0.0, 0.0, window->width, window->height);
        cairo_clip(context);
    }
    setColor(context, layer.color);
    const double dashes[] = {layer.dash, layer.gap};
    if (layer.dash > 0.0) cairo_set_dash(context, dashes, 2, 0.0);
    for (const DrawnPath& drawn : layer.paths) {
        CairoPath path{context};
        drawn.path.copyTo(path);
        cairo_set_line_width(context, drawn.width);
        if (layer.filled) {
            cairo_fill(context);
        } else {
            cairo_stroke(context);
        }
    }
    cairo_restore(context);
}

void draw(cairo_t* context, const Drawing& drawing) {
    if (drawing.background) {
        setColor(context, *drawing.background);
        cairo_paint(context);
    }
    for (const DrawnImage& image : drawing.images) draw(context, image);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    for (const Layer& layer : drawing.layers) draw(context, layer, drawing.window);
}

EncodedDocument encodePdf(const Drawing& drawing) {
    EncodedDocument result;
    const Page& page = drawing.page;
    const double scale = pointsPerInch / page.dpi;
    const glm::dvec2 size = page.paper
                                ? pointsPerInch / millimetresPerInch * glm::dvec2{page.paper->width, page.paper->height}
                                : scale * page.size;
    const Surface surface{cairo_pdf_surface_create_for_stream(append, &result.bytes, size.x, size.y),
                          cairo_surface_destroy};
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_SUBJECT, drawing.description.c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);  // the same bytes each time
    const Context context{cairo_create(surface.get()), cairo_destroy};
    cairo_scale(context.get(), scale, scale);
    draw(context.get(), drawing);
    cairo_show_page(context.get());
    cairo_status_t status = cairo_status(context.get());
    cairo_surface_finish(surface.get());
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc{};
    if (status != CAIRO_STATUS_SUCCESS) result.failure = modules::oneLine(cairo_status_to_string(status));
    return result;
}

PaintedDrawing paint(const Drawing& drawing, Size size) {
    PaintedDrawing result{Image<std::uint8_t>{size, 3}, {}};
    const Surface surface{cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height),
                          cairo_surface_destroy};
    const Context context{cairo_create(surface.get()), cairo_destroy};
    setColor(context.get(), {255, 255, 255});
    cairo_paint(context.get());
    cairo_scale(context.get(), size.width / drawing.page.size.x, size.height / drawing.page.size.y);
    draw(context.get(), drawing);
    cairo_surface_flush(surface.get());
    const cairo_status_t status = cairo_status(context.get());
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc{};
    if (status != CAIRO_STATUS_SUCCESS) {
        result.failure = modules::oneLine(cairo_status_to_string(status));
        return result;
    }
    const unsigned char* const rows = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, rows + static_cast<std::ptrdiff_t>(y) * stride + 4 * static_cast<std::ptrdiff_t>(x), 4);
            for (int c = 0; c < 3; ++c)
                result.picture(x, y, c) = static_cast<std::uint8_t>(pixel >> (16U - 8U * static_cast<unsigned>(c)));
        }
    }
    return result;
}

}  // namespace

extern "C" INKEDGE_API const VectorFormats* inkedge_vector_formats_1() noexcept {
    static constexpr VectorFormats formats{
        [](const Drawing& drawing) { return modules::guarded([&] { return encodePdf(drawing); }); },
        [](const Drawing& drawing, Size size) { return modules::guarded([&] { return paint(drawing, size); }); }};
    return &formats;
}

}  // namespace inkedge::io
