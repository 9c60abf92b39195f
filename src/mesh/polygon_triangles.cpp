#include "mesh/polygon_triangles.h"

#include <algorithm>
#include <deque>
#include <memory>

#include <GL/glu.h>
#include <dlfcn.h>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge {
namespace {

using Callback = void (*)();

double signedDoubleArea(const Polygon& polygon) {
    double area = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

// The tessellator of the OpenGL Utility Library, which needs no context. It is loaded when a cut-out first asks for it:
// linked, it would cost every start, and its gl functions would come before OSMesa's.
struct Glu {
    decltype(&gluNewTess) newTess;
    decltype(&gluDeleteTess) deleteTess;
    decltype(&gluTessCallback) callback;
    decltype(&gluTessProperty) property;
    decltype(&gluTessNormal) normal;
    decltype(&gluTessBeginPolygon) beginPolygon;
    decltype(&gluTessBeginContour) beginContour;
    decltype(&gluTessVertex) vertex;
    decltype(&gluTessEndContour) endContour;
    decltype(&gluTessEndPolygon) endPolygon;
};

const Glu& glu() {
    static const Glu functions = [] {
        constexpr const char* name = "libGLU.so.1";
        void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) load::refuse(fmt::format("expected {} for its outline, found: {}", name, dlerror()));
        const auto find = [&]<class Function>(Function& function, const char* symbol) {
            function = reinterpret_cast<Function>(dlsym(library, symbol));
            if (function == nullptr) load::refuse(fmt::format("expected {} in {}, found it missing", symbol, name));
        };
        Glu found{};
        find(found.newTess, "gluNewTess");
        find(found.deleteTess, "gluDeleteTess");
        find(found.callback, "gluTessCallback");
        find(found.property, "gluTessProperty");
        find(found.normal, "gluTessNormal");
        find(found.beginPolygon, "gluTessBeginPolygon");
        find(found.beginContour, "gluTessBeginContour");
        find(found.vertex, "gluTessVertex");
        find(found.endContour, "gluTessEndContour");
        find(found.endPolygon, "gluTessEndPolygon");
        return found;
    }();
    return functions;
}

// One run of the tessellator. Its callbacks are called from C, which no exception may pass: memory that is lacking there
// ends the process.
class Tessellation {
public:
    // Loops of what the rule says is inside, or, with GL_FALSE, triangles: as many loops of three.
    static std::vector<Polygon> run(std::span<const Polygon> first, const Polygon* second, GLenum rule,
                                    GLboolean bordersOnly) {
        Tessellation run;
        const Glu& f = glu();
        const std::unique_ptr<GLUtesselator, decltype(f.deleteTess)> tess{f.newTess(), f.deleteTess};
        if (!tess) throw std::bad_alloc{};
        f.property(tess.get(), GLU_TESS_WINDING_RULE, rule);
        f.property(tess.get(), GLU_TESS_BOUNDARY_ONLY, bordersOnly);
        f.normal(tess.get(), 0.0, 0.0, 1.0);
        f.callback(tess.get(), GLU_TESS_BEGIN_DATA, reinterpret_cast<Callback>(&begin));
        f.callback(tess.get(), GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(&vertex));
        f.callback(tess.get(), GLU_TESS_COMBINE_DATA, reinterpret_cast<Callback>(&combine));
        f.callback(tess.get(), GLU_TESS_ERROR_DATA, reinterpret_cast<Callback>(&error));
        // With this one it gives triangles alone, no fans or strips.
        if (bordersOnly == GL_FALSE) f.callback(tess.get(), GLU_TESS_EDGE_FLAG, reinterpret_cast<Callback>(&edgeFlag));
        f.beginPolygon(tess.get(), &run);
        for (const Polygon& polygon : first) run.add(f, tess.get(), polygon);
        if (second != nullptr) run.add(f, tess.get(), *second);
        f.endPolygon(tess.get());
        if (run.failed_) load::refuse("expected an outline that can be cut along, found one that cannot");
        return std::move(run.loops_);
    }

private:
    struct Vertex {
        GLdouble place[3];
    };

    void add(const Glu& f, GLUtesselator* tess, const Polygon& polygon) {
        f.beginContour(tess);
        for (const glm::dvec2& p : polygon) {
            vertices_.push_back({{p.x, p.y, 0.0}});
            f.vertex(tess, vertices_.back().place, &vertices_.back());
        }
        f.endContour(tess);
    }

    static void begin(GLenum, void* self) noexcept { static_cast<Tessellation*>(self)->loops_.emplace_back(); }
    static void vertex(void* vertex, void* self) noexcept {
        const auto* const v = static_cast<const Vertex*>(vertex);
        static_cast<Tessellation*>(self)->loops_.back().emplace_back(v->place[0], v->place[1]);
    }
    static void combine(GLdouble place[3], void* [4], GLfloat[4], void** made, void* self) noexcept {
        auto& vertices = static_cast<Tessellation*>(self)->vertices_;
        vertices.push_back({{place[0], place[1], 0.0}});
        *made = &vertices.back();
    }
    static void error(GLenum, void* self) noexcept { static_cast<Tessellation*>(self)->failed_ = true; }
    static void edgeFlag(GLboolean) noexcept {}

    std::deque<Vertex> vertices_;  // which the tessellator points to
    std::vector<Polygon> loops_;
    bool failed_ = false;
};

}  // namespace

std::vector<PolygonTriangle> convexTriangles(const Polygon& polygon) {
    std::vector<PolygonTriangle> triangles;
    const bool anticlockwise = signedDoubleArea(polygon) >= 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        PolygonTriangle t{polygon[0], polygon[i - 1], polygon[i]};
        if (!anticlockwise) std::swap(t[1], t[2]);
        triangles.push_back(t);
    }
    return triangles;
}

std::vector<Polygon> untangled(std::span<const Polygon> loops) {
    return Tessellation::run(loops, nullptr, GLU_TESS_WINDING_NONZERO, GL_TRUE);
}

std::vector<PolygonTriangle> trianglesWithin(const Polygon& polygon, std::span<const Polygon> area) {
    Polygon anticlockwise = polygon;
    if (signedDoubleArea(polygon) < 0.0) std::ranges::reverse(anticlockwise);
    // Where both go around a place they do so twice.
    std::vector<PolygonTriangle> triangles;
    for (const Polygon& run : Tessellation::run(area, &anticlockwise, GLU_TESS_WINDING_ABS_GEQ_TWO, GL_FALSE))
        for (std::size_t i = 2; i < run.size(); i += 3) triangles.push_back({run[i - 2], run[i - 1], run[i]});
    return triangles;
}

}  // namespace inkedge
