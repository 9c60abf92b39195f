#include "mesh/tessellator.h"

#include <deque>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include <GL/glu.h>

#include <inkedge/export.h>

#include "modules/failure.h"

namespace inkedge::mesh {
namespace {

using Callback = void (*)();

// One run of the tessellator, which needs no context. C code calls the callbacks, and no exception may pass through C
// code: if memory runs out there, the process ends.
class Run {
public:
    // The border of the area that is inside by the rule or, with bordersOnly GL_FALSE, its triangles as loops of three.
    static Tessellation of(std::span<const Polygon> first, const Polygon* second, GLenum rule, GLboolean bordersOnly) {
        Run run;
        const std::unique_ptr<GLUtesselator, decltype(&gluDeleteTess)> tess{gluNewTess(), gluDeleteTess};
        if (!tess) throw std::bad_alloc{};
        gluTessProperty(tess.get(), GLU_TESS_WINDING_RULE, rule);
        gluTessProperty(tess.get(), GLU_TESS_BOUNDARY_ONLY, bordersOnly);
        gluTessNormal(tess.get(), 0.0, 0.0, 1.0);
        gluTessCallback(tess.get(), GLU_TESS_BEGIN_DATA, reinterpret_cast<Callback>(&begin));
        gluTessCallback(tess.get(), GLU_TESS_VERTEX_DATA, reinterpret_cast<Callback>(&vertex));
        gluTessCallback(tess.get(), GLU_TESS_COMBINE_DATA, reinterpret_cast<Callback>(&combine));
        gluTessCallback(tess.get(), GLU_TESS_ERROR_DATA, reinterpret_cast<Callback>(&error));
        // With an edge flag callback the tessellator yields triangles only, no fans or strips.
        if (bordersOnly == GL_FALSE)
            gluTessCallback(tess.get(), GLU_TESS_EDGE_FLAG, reinterpret_cast<Callback>(&edgeFlag));
        gluTessBeginPolygon(tess.get(), &run);
        for (const Polygon& polygon : first) run.add(tess.get(), polygon);
        if (second != nullptr) run.add(tess.get(), *second);
        gluTessEndPolygon(tess.get());
        if (run.failed_) throw std::runtime_error{"expected an outline that can be cut along, found one that cannot"};
        return {std::move(run.loops_), {}};
    }

private:
    struct Vertex {
        GLdouble position[3];
    };

    void add(GLUtesselator* tess, const Polygon& polygon) {
        gluTessBeginContour(tess);
        for (const glm::dvec2& p : polygon) {
            vertices_.push_back({{p.x, p.y, 0.0}});
            gluTessVertex(tess, vertices_.back().position, &vertices_.back());
        }
        gluTessEndContour(tess);
    }

    static void begin(GLenum, void* self) noexcept { static_cast<Run*>(self)->loops_.emplace_back(); }
    static void vertex(void* vertex, void* self) noexcept {
        const auto* const v = static_cast<const Vertex*>(vertex);
        static_cast<Run*>(self)->loops_.back().emplace_back(v->position[0], v->position[1]);
    }
    static void combine(GLdouble position[3], void* [4], GLfloat[4], void** made, void* self) noexcept {
        auto& vertices = static_cast<Run*>(self)->vertices_;
        vertices.push_back({{position[0], position[1], 0.0}});
        *made = &vertices.back();
    }
    static void error(GLenum, void* self) noexcept { static_cast<Run*>(self)->failed_ = true; }
    static void edgeFlag(GLboolean) noexcept {}

    std::deque<Vertex> vertices_;  // the tessellator holds pointers to them
    std::vector<Polygon> loops_;
    bool failed_ = false;
};

}  // namespace

extern "C" INKEDGE_API const Tessellator* inkedge_tessellator_1() noexcept {
    static constexpr Tessellator functions{
        [](std::span<const Polygon> loops) {
            return modules::guarded([&] { return Run::of(loops, nullptr, GLU_TESS_WINDING_NONZERO, GL_TRUE); });
        },
        [](std::span<const Polygon> area, const Polygon& other) {
            // The winding number is 2 where both the area and the loop enclose a point.
            return modules::guarded([&] { return Run::of(area, &other, GLU_TESS_WINDING_ABS_GEQ_TWO, GL_FALSE); });
        }};
    return &functions;
}

}  // namespace inkedge::mesh
