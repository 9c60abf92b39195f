#include "io/dxf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <inkedge/write.h>

#include "io/dxf_colors.h"
#include "settings/lengths.h"

// Written by hand, after Autodesk's DXF Reference of 2000 (AC1015): no library in Debian writes it. The tables and
// objects beside layers and entities are the fewest that strict readers take.

namespace inkedge {
namespace io {
namespace {

// What is numbered from the start; the rest is numbered as it is written.
enum Handle : std::uint32_t {
    viewportTable = 1,
    lineTypeTable,
    layerTable,
    styleTable,
    viewTable,
    coordinateSystemTable,
    applicationTable,
    dimensionStyleTable,
    blockTable,
    modelSpace,
    paperSpace,
    rootDictionary,
    groupDictionary,
    firstFree
};

// Pairs of a code and a value, of which DXF consists.
class Pairs {
public:
    explicit Pairs(int decimals) : decimals_{decimals} {}
    void text(int code, std::string_view value) {
        fmt::format_to(std::back_inserter(all_), "{:>3}\n{}\n", code, value);
    }
    void whole(int code, long long value) { fmt::format_to(std::back_inserter(all_), "{:>3}\n{}\n", code, value); }
    void handle(int code, std::uint32_t value) {
        fmt::format_to(std::back_inserter(all_), "{:>3}\n{:X}\n", code, value);
    }
    void number(int code, double value) {
        std::string digits = fmt::format("{:.{}f}", value, decimals_);
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.') digits += '0';
        text(code, digits == "-0.0" ? "0.0" : digits);
    }
    void point(int code, glm::dvec2 p) {
        number(code, p.x);
        number(code + 10, p.y);
    }
    [[nodiscard]] std::string& all() { return all_; }

private:
    std::string all_;
    int decimals_;
};

struct Vertex {
    glm::dvec2 at;
    double bulge = 0.0;  // of the way to the next: the tangent of a quarter of an arc's angle, over 0 to the left
};

// The subpaths of a path as polylines, in millimetres.
class Polylines {
public:
    struct Polyline {
        std::vector<Vertex> vertices;
        bool closed = false;
    };

    Polylines(glm::dvec2 origin, double pageHeight, double pixel)
        : origin_{origin}, pageHeight_{pageHeight}, pixel_{pixel} {}
    void moveTo(glm::dvec2 to) {
        all_.emplace_back();
        add(to);
    }
    void lineTo(glm::dvec2 to) { add(to); }
    void curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 to) {
        constexpr double tolerance = 0.05;  // pixels
        const glm::dvec2 from = at_;
        const double bend =
            std::max(glm::length(from - 2.0 * control1 + control2), glm::length(control1 - 2.0 * control2 + to));
        const int count = std::clamp(static_cast<int>(std::ceil(std::sqrt(0.75 * bend / tolerance))), 1, 1000);
        for (int i = 1; i < count; ++i) {
            const double t = static_cast<double>(i) / count;
            const double s = 1.0 - t;
            add(s * s * s * from + 3.0 * s * s * t * control1 + 3.0 * s * t * t * control2 + t * t * t * to);
        }
        add(to);
    }
    void arcTo(double radius, glm::dvec2 to) {
        const double half = 0.5 * glm::distance(at_, to);
        if (half == 0.0) return;
        const double angle = 2.0 * std::asin(std::min(half / radius, 1.0));
        all_.back().vertices.back().bulge = -std::tan(0.25 * angle);
        add(to);
    }
    void close() { all_.back().closed = true; }

    [[nodiscard]] const std::vector<Polyline>& all() const noexcept { return all_; }

private:
    void add(glm::dvec2 pixel) {
        at_ = pixel;
        const glm::dvec2 onPage = origin_ + pixel;
        all_.back().vertices.push_back({pixel_ * glm::dvec2{onPage.x, pageHeight_ - onPage.y}});
    }

    glm::dvec2 origin_;
    double pageHeight_;
    double pixel_;
    glm::dvec2 at_{0.0};
    std::vector<Polyline> all_;
};

// What all layers of one name have.
struct SharedLayer {
    std::string name;
    Color color;
    double width;
    double dash;
    double gap;
};

// The one dashed line type, of the first dashed layer; others have it at a scale. LibreCAD knows line types by name.
constexpr std::string_view dashedType = "HIDDEN2";

class Writer {
public:
    Writer(const Drawing& drawing, double pixel) : drawing_{drawing}, pixel_{pixel} {
        for (const Layer& layer : drawing.layers) {
            if (std::ranges::find(layers_, layer.name, &SharedLayer::name) == layers_.end())
                layers_.push_back({layer.name, layer.color, layer.width, layer.dash, layer.gap});
        }
        const auto first = std::ranges::find_if(layers_, [](const SharedLayer& layer) { return layer.dash > 0.0; });
        if (first != layers_.end()) dashed_ = &*first;
    }

    std::string write() {
        Pairs entities = blank();
        writeEntities(entities);
        Pairs body = blank();
        section(body, "CLASSES");
        body.text(0, "ENDSEC");
        writeTables(body);
        writeBlocks(body);
        body.all() += entities.all();
        writeObjects(body);
        body.text(0, "EOF");
        Pairs file = blank();  // it says how many handles there are, and where the drawing lies
        writeHeader(file);
        return std::move(file.all()) + body.all();
    }

private:
    // A thousandth of a pixel shows.
    [[nodiscard]] Pairs blank() const {
        return Pairs{std::clamp(static_cast<int>(std::ceil(3.0 - std::log10(pixel_))), 3, 15)};
    }
    [[nodiscard]] glm::dvec2 pageSize() const { return pixel_ * drawing_.page.size; }
    [[nodiscard]] double onPaper(double pixels) const {
        return pixels * settings::millimetresPerInch / drawing_.page.dpi;
    }
    [[nodiscard]] static std::string_view dashesOf(const SharedLayer& layer) {
        return layer.dash > 0.0 ? dashedType : "Continuous";
    }

    static void section(Pairs& to, std::string_view name) {
        to.text(0, "SECTION");
        to.text(2, name);
    }

    void writeHeader(Pairs& to) const {
        section(to, "HEADER");
        const auto variable = [&](std::string_view name) { to.text(9, name); };
        variable("$ACADVER");
        to.text(1, "AC1015");
        variable("$DWGCODEPAGE");
        to.text(3, "ANSI_1252");
        const bool empty = low_.x > high_.x;
        const auto corner = [&](std::string_view name, glm::dvec2 at) {
            variable(name);
            to.point(10, at);
        };
        corner("$EXTMIN", empty ? glm::dvec2{0.0} : low_);
        to.number(30, 0.0);
        corner("$EXTMAX", empty ? pageSize() : high_);
        to.number(30, 0.0);
        corner("$LIMMIN", {0.0, 0.0});
        corner("$LIMMAX", pageSize());
        const auto count = [&](std::string_view name, int code, int value) {
            variable(name);
            to.whole(code, value);
        };
        count("$INSUNITS", 70, 4);  // millimetres
        count("$MEASUREMENT", 70, 1);
        count("$LWDISPLAY", 290, 1);
        variable("$LTSCALE");
        to.number(40, 1.0);
        variable("$HANDSEED");
        to.handle(5, next_);
        to.text(0, "ENDSEC");
    }

    static void beginTable(Pairs& to, std::string_view name, Handle handle, std::size_t count) {
        to.text(0, "TABLE");
        to.text(2, name);
        to.handle(5, handle);
        to.handle(330, 0);
        to.text(100, "AcDbSymbolTable");
        to.whole(70, static_cast<long long>(count));
    }

    void record(Pairs& to, std::string_view type, Handle table, std::string_view subclass, std::string_view name) {
        to.text(0, type);
        to.handle(type == "DIMSTYLE" ? 105 : 5, next_++);
        to.handle(330, table);
        to.text(100, "AcDbSymbolTableRecord");
        to.text(100, subclass);
        to.text(2, name);
        to.whole(70, 0);
    }

    void writeTables(Pairs& to) {
        section(to, "TABLES");
        writeViewport(to);
        writeLineTypes(to);
        writeLayers(to);
        beginTable(to, "STYLE", styleTable, 1);
        record(to, "STYLE", styleTable, "AcDbTextStyleTableRecord", "Standard");
        for (const auto& [code, value] : {std::pair{40, 0.0}, {41, 1.0}, {50, 0.0}, {42, 2.5}}) to.number(code, value);
        to.whole(71, 0);
        to.text(3, "txt");
        to.text(4, "");
        to.text(0, "ENDTAB");
        beginTable(to, "VIEW", viewTable, 0);
        to.text(0, "ENDTAB");
        beginTable(to, "UCS", coordinateSystemTable, 0);
        to.text(0, "ENDTAB");
        beginTable(to, "APPID", applicationTable, 1);
        record(to, "APPID", applicationTable, "AcDbRegAppTableRecord", "ACAD");
        to.text(0, "ENDTAB");
        beginTable(to, "DIMSTYLE", dimensionStyleTable, 1);
        to.text(100, "AcDbDimStyleTable");
        to.whole(71, 0);
        record(to, "DIMSTYLE", dimensionStyleTable, "AcDbDimStyleTableRecord", "Standard");
        to.text(0, "ENDTAB");
        beginTable(to, "BLOCK_RECORD", blockTable, 2);
        for (const auto& [name, handle] : {std::pair{"*Model_Space", modelSpace}, {"*Paper_Space", paperSpace}}) {
            to.text(0, "BLOCK_RECORD");
            to.handle(5, handle);
            to.handle(330, blockTable);
            to.text(100, "AcDbSymbolTableRecord");
            to.text(100, "AcDbBlockTableRecord");
            to.text(2, name);
        }
        to.text(0, "ENDTAB");
        to.text(0, "ENDSEC");
    }

    // What a reader shows first: the whole page.
    void writeViewport(Pairs& to) {
        const glm::dvec2 size = pageSize();
        beginTable(to, "VPORT", viewportTable, 1);
        record(to, "VPORT", viewportTable, "AcDbViewportTableRecord", "*Active");
        to.point(10, {0.0, 0.0});
        to.point(11, {1.0, 1.0});
        to.point(12, 0.5 * size);
        to.point(13, {0.0, 0.0});
        for (const int code : {14, 15}) to.point(code, {10.0, 10.0});
        for (const int code : {16, 17}) {  // looks along -z at the origin
            to.point(code, {0.0, 0.0});
            to.number(code + 20, code == 16 ? 1.0 : 0.0);
        }
        to.number(40, size.y);
        to.number(41, size.x / size.y);
        to.number(42, 50.0);
        for (const int code : {43, 44, 50, 51}) to.number(code, 0.0);
        for (const auto& [code, value] :
             {std::pair{71, 0}, {72, 1000}, {73, 1}, {74, 3}, {75, 0}, {76, 0}, {77, 0}, {78, 0}})
            to.whole(code, value);
        to.text(0, "ENDTAB");
    }

    void lineType(Pairs& to, std::string_view name, std::string_view description, std::initializer_list<double> parts) {
        record(to, "LTYPE", lineTypeTable, "AcDbLinetypeTableRecord", name);
        double length = 0.0;
        for (const double part : parts) length += std::abs(part);
        to.text(3, description);
        to.whole(72, 65);
        to.whole(73, static_cast<long long>(parts.size()));
        to.number(40, length);
        for (const double part : parts) {
            to.number(49, part);
            to.whole(74, 0);
        }
    }

    // Dashes as they are seen: our pens' round tips make them longer by a width, and gaps shorter.
    void writeLineTypes(Pairs& to) {
        beginTable(to, "LTYPE", lineTypeTable, dashed_ != nullptr ? 4 : 3);
        lineType(to, "ByBlock", "", {});
        lineType(to, "ByLayer", "", {});
        lineType(to, "Continuous", "Solid line", {});
        if (dashed_ != nullptr) {
            const double tip = std::min(dashed_->width, 0.5 * dashed_->gap);
            lineType(to, dashedType, "Hidden __ __ __",
                     {pixel_ * (dashed_->dash + tip), -pixel_ * (dashed_->gap - tip)});
        }
        to.text(0, "ENDTAB");
    }

    void writeLayers(Pairs& to) {
        beginTable(to, "LAYER", layerTable, layers_.size() + 1);
        const auto layer = [&](std::string_view name, int color, std::string_view dashes, int width) {
            record(to, "LAYER", layerTable, "AcDbLayerTableRecord", name);
            to.whole(62, color);
            to.text(6, dashes);
            to.whole(370, width);
        };
        layer("0", 7, "Continuous", -3);  // -3: the reader's default width
        for (const SharedLayer& each : layers_)
            layer(each.name, dxfColor(each.color), dashesOf(each), dxfLineWidth(onPaper(each.width)));
        to.text(0, "ENDTAB");
    }

    void writeBlocks(Pairs& to) {
        section(to, "BLOCKS");
        for (const auto& [name, owner] : {std::pair{"*Model_Space", modelSpace}, {"*Paper_Space", paperSpace}}) {
            const auto entity = [&, handle = owner](std::string_view type, std::string_view subclass) {
                to.text(0, type);
                to.handle(5, next_++);
                to.handle(330, handle);
                to.text(100, "AcDbEntity");
                if (handle == paperSpace) to.whole(67, 1);
                to.text(8, "0");
                to.text(100, subclass);
            };
            entity("BLOCK", "AcDbBlockBegin");
            to.text(2, name);
            to.whole(70, 0);
            to.point(10, {0.0, 0.0});
            to.number(30, 0.0);
            to.text(3, name);
            to.text(1, "");
            entity("ENDBLK", "AcDbBlockEnd");
        }
        to.text(0, "ENDSEC");
    }

    void writeEntities(Pairs& to) {
        section(to, "ENTITIES");
        for (const Layer& layer : drawing_.layers) {
            const SharedLayer& shared = *std::ranges::find(layers_, layer.name, &SharedLayer::name);
            const int layerWidth = dxfLineWidth(onPaper(shared.width));
            for (const DrawnPath& drawn : layer.paths) {
                Polylines polylines{layer.origin, drawing_.page.size.y, pixel_};
                drawn.path.copyTo(polylines);
                const int width = dxfLineWidth(onPaper(drawn.width));
                for (const Polylines::Polyline& polyline : polylines.all())
                    writePolyline(to, shared, width == layerWidth ? -1 : width, polyline);
            }
        }
        to.text(0, "ENDSEC");
    }

    // @param width  as dxfLineWidth(); -1: the layer's
    void writePolyline(Pairs& to, const SharedLayer& layer, int width, const Polylines::Polyline& polyline) {
        if (polyline.vertices.size() < 2) return;
        to.text(0, "LWPOLYLINE");
        to.handle(5, next_++);
        to.handle(330, modelSpace);
        to.text(100, "AcDbEntity");
        to.text(8, layer.name);
        if (layer.dash > 0.0 && layer.dash != dashed_->dash) to.number(48, layer.dash / dashed_->dash);
        if (width >= 0) to.whole(370, width);
        to.text(100, "AcDbPolyline");
        to.whole(90, static_cast<long long>(polyline.vertices.size()));
        to.whole(70, polyline.closed ? 1 : 0);
        for (const Vertex& vertex : polyline.vertices) {
            to.point(10, vertex.at);
            if (vertex.bulge != 0.0) to.number(42, vertex.bulge);
            low_ = glm::min(low_, vertex.at);
            high_ = glm::max(high_, vertex.at);
        }
    }

    static void writeObjects(Pairs& to) {
        section(to, "OBJECTS");
        const auto dictionary = [&](Handle handle, std::uint32_t owner) {
            to.text(0, "DICTIONARY");
            to.handle(5, handle);
            to.handle(330, owner);
            to.text(100, "AcDbDictionary");
            to.whole(281, 1);
        };
        dictionary(rootDictionary, 0);
        to.text(3, "ACAD_GROUP");
        to.handle(350, groupDictionary);
        dictionary(groupDictionary, rootDictionary);
        to.text(0, "ENDSEC");
    }

    const Drawing& drawing_;
    double pixel_;
    std::vector<SharedLayer> layers_;
    const SharedLayer* dashed_ = nullptr;  // none: all lines are solid
    std::uint32_t next_ = firstFree;
    glm::dvec2 low_{std::numeric_limits<double>::max()};
    glm::dvec2 high_{std::numeric_limits<double>::lowest()};
};

// Millimetres of a pixel: of the paper if a size on paper is asked for, or the view has no scale; else of the model.
double pixelOf(const Lines& lines, const Settings& settings, const Page& page) {
    const bool onPaper = settings.picture.page || settings::isSizedOnPaper(settings.frame);
    if (onPaper || !lines.camera.orthographic()) return settings::millimetresPerInch / page.dpi;
    return settings::millimetresOf(lines.source.unit) / lines.camera.focalLength(lines.size);
}

}  // namespace

std::string dxfOf(const Drawing& drawing, double pixel) { return Writer{drawing, pixel}.write(); }

}  // namespace io

std::string linesDxf(const Lines& lines, const Settings& settings) {
    const io::Drawing drawing = io::drawingOf(lines, settings, {}, io::VaryingWidths::Centres);
    return io::dxfOf(drawing, io::pixelOf(lines, settings, drawing.page));
}

}  // namespace inkedge
