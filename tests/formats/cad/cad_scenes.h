#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/load_scene.h>

#include "formats/cad/cad_files.h"

namespace inkedge::cad {

using cad_files::Shape;

inline Scene sceneOf(const std::string& text, const std::string& name, const LoadSettings& settings = {}) {
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    return loadScene(bytes, name, settings);
}
// For a small picture, for speed.
inline Scene sceneOf(Shape shape, const std::optional<LoadSettings>& settings = {}) {
    LoadSettings small;
    small.pictures.picture.size = {256, 256};
    return sceneOf(cad_files::step(shape), "part.step", settings.value_or(small));
}

inline glm::dvec3 position(const Mesh& mesh, std::size_t corner) {
    return glm::dvec3{mesh.positions[mesh.indices[corner]]} + mesh.origin;
}

inline void expectNear(const glm::dvec3& a, const glm::dvec3& b, double within) {
    EXPECT_NEAR(a.x, b.x, within);
    EXPECT_NEAR(a.y, b.y, within);
    EXPECT_NEAR(a.z, b.z, within);
}
inline void expectBox(const Scene& scene, const glm::dvec3& low, const glm::dvec3& high) {
    expectNear(scene.box().min, low, 1e-5);
    expectNear(scene.box().max, high, 1e-5);
}

struct Known {
    Shape shape;
    std::function<glm::dvec3(glm::dvec3)> normal;  ///< at a point of the surface that is on no edge
    std::function<double(glm::dvec3)> distance;    ///< from the surface, over 0 outside
};

inline const std::vector<Known>& known() {
    const auto flat = [](glm::dvec3 p) { return glm::dvec3{p.x, p.y, 0.0}; };
    const auto tube = [](glm::dvec3 p) {
        const glm::dvec3 middle = 8.0 * glm::normalize(glm::dvec3{p.x, p.y, 0.0});
        return p - middle;
    };
    static const std::vector<Known> all{
        {Shape::Cylinder,
         [=](glm::dvec3 p) {
             return std::abs(p.z) < 1e-4        ? glm::dvec3{0, 0, -1}
                    : std::abs(p.z - 12) < 1e-4 ? glm::dvec3{0, 0, 1}
                                                : flat(p) / 5.0;
         },
         [=](glm::dvec3 p) {
             return std::max({glm::length(flat(p)) - 5.0, -p.z, p.z - 12.0});
         }},
        {Shape::Sphere, [](glm::dvec3 p) { return p / 4.0; }, [](glm::dvec3 p) { return glm::length(p) - 4.0; }},
        {Shape::Torus, [=](glm::dvec3 p) { return tube(p) / 3.0; },
         [=](glm::dvec3 p) { return glm::length(tube(p)) - 3.0; }},
        {Shape::SplineTorus, [=](glm::dvec3 p) { return tube(p) / 3.0; },
         [=](glm::dvec3 p) { return glm::length(tube(p)) - 3.0; }},
    };
    return all;
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) ADD_FAILURE() << "no " << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

// The box once more, by a MAPPED_ITEM with a CARTESIAN_TRANSFORMATION_OPERATOR_3D.
inline std::string mapped(const std::string& operatorText) {
    std::string text = cad_files::step(Shape::Box);
    const std::size_t at = text.find("ADVANCED_BREP_SHAPE_REPRESENTATION");
    const std::size_t hash = text.rfind('#', at);
    const std::string representation = text.substr(hash, text.find(' ', hash) - hash);
    const std::size_t end = text.find(';', at);
    const std::size_t context = text.rfind('#', end);
    const std::string contextName = text.substr(context, text.rfind(')', end) - context);
    const std::size_t shape = text.find("SHAPE_DEFINITION_REPRESENTATION");
    const std::size_t shapeEnd = text.find(')', shape);
    text.replace(text.rfind('#', shapeEnd), shapeEnd - text.rfind('#', shapeEnd), "#9000");
    return replaced(
        text, "ENDSEC;\nEND-ISO",
        "#9000 = SHAPE_REPRESENTATION('',(#9010,#9001,#9002)," + contextName +
            ");\n#9001 = MAPPED_ITEM('',#9003,#9010);\n#9002 = MAPPED_ITEM('arm',#9003,#9020);\n"
            "#9003 = REPRESENTATION_MAP(#9010," +
            representation +
            ");\n#9010 = AXIS2_PLACEMENT_3D('',#9011,#9012,#9013);\n#9011 = CARTESIAN_POINT('',(0.,0.,0.));\n"
            "#9012 = DIRECTION('',(0.,0.,1.));\n#9013 = DIRECTION('',(1.,0.,0.));\n"
            "#9020 = CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',''," +
            operatorText +
            ");\n#9021 = DIRECTION('',(-1.,0.,0.));\n#9022 = DIRECTION('',(0.,1.,0.));\n"
            "#9023 = CARTESIAN_POINT('',(-5.,0.,0.));\nENDSEC;\nEND-ISO");
}

}  // namespace inkedge::cad
