#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <inkedge/load_scene.h>

#include "formats/cad/cad_files.h"

namespace inkedge::cad {

using cad_files::Shape;

inline Scene sceneOf(const std::string& text, const std::string& name, const LoadSettings& settings = {}) {
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    return loadScene(bytes, name, settings);
}
// For speed.
inline LoadSettings ofSmallPicture() {
    LoadSettings settings;
    settings.pictures.picture.size = {256, 256};
    return settings;
}
inline Scene sceneOf(Shape shape, const std::optional<LoadSettings>& settings = {}) {
    const bool onlyBrep = shape == Shape::ScaledTorus || shape == Shape::OffsetTorus;
    const std::string text = onlyBrep ? cad_files::brep(shape) : cad_files::step(shape);
    return sceneOf(text, "part", settings.value_or(ofSmallPicture()));
}

inline glm::dvec3 position(const Mesh& mesh, std::size_t corner) {
    return glm::dvec3{mesh.positions[mesh.indices[corner]]} + mesh.origin;
}

inline double areaOf(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3)
        area += 0.5 * glm::length(glm::cross(position(mesh, c + 1) - position(mesh, c),
                                             position(mesh, c + 2) - position(mesh, c)));
    return area;
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

// From a cone of radius 6 at z = 0, apex at z = 8: in the half-plane of its axis that is a triangle.
inline double toCone(glm::dvec3 p) {
    const glm::dvec2 at{std::hypot(p.x, p.y), p.z};
    const auto toSegment = [&](glm::dvec2 a, glm::dvec2 b) {
        const double share = std::clamp(glm::dot(at - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        return glm::distance(at, glm::mix(a, b, share));
    };
    const double distance = std::min(toSegment({6, 0}, {0, 8}), toSegment({0, 0}, {6, 0}));
    return at.y > 0.0 && 0.8 * at.x + 0.6 * (at.y - 8.0) < 0.0 ? -distance : distance;
}

// Whether a point lies on an edge of a shape that is none of its surface, or where the surface has no normal.
inline bool isOnEdge(Shape shape, glm::dvec3 p) {
    const double r = std::hypot(p.x, p.y);
    const auto isAt = [&](double radius, double z) { return std::abs(r - radius) < 1e-4 && std::abs(p.z - z) < 1e-4; };
    if (shape == Shape::Cone || shape == Shape::SplineCone) return isAt(6.0, 0.0) || isAt(0.0, 8.0);
    return shape == Shape::Cylinder && (isAt(5.0, 0.0) || isAt(5.0, 12.0));
}

struct Known {
    Shape shape;
    std::function<glm::dvec3(glm::dvec3)> normal;  ///< at a point of the surface that is on no edge; 0 at an apex
    std::function<double(glm::dvec3)> distance;    ///< from the surface, over 0 outside
};

inline const std::vector<Known>& known() {
    const auto flat = [](glm::dvec3 p) { return glm::dvec3{p.x, p.y, 0.0}; };
    const auto tube = [](glm::dvec3 p) {
        const glm::dvec3 middle = 8.0 * glm::normalize(glm::dvec3{p.x, p.y, 0.0});
        return p - middle;
    };
    const auto ofTorus = [=](glm::dvec3 p) { return tube(p) / 3.0; };
    const auto toTorus = [=](glm::dvec3 p) { return glm::length(tube(p)) - 3.0; };
    const auto ofCone = [=](glm::dvec3 p) {
        if (std::abs(p.z) < 1e-4) return glm::dvec3{0, 0, -1};
        return p.z > 8.0 - 1e-4 ? glm::dvec3{0.0} : 0.8 * glm::normalize(flat(p)) + glm::dvec3{0, 0, 0.6};
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
        {Shape::Cone, ofCone, toCone},
        {Shape::Sphere, [](glm::dvec3 p) { return p / 4.0; }, [](glm::dvec3 p) { return glm::length(p) - 4.0; }},
        {Shape::Torus, ofTorus, toTorus},
        {Shape::SplineTorus, ofTorus, toTorus},
        {Shape::OffsetTorus, ofTorus, toTorus},
        {Shape::ScaledTorus, ofTorus, toTorus},
    };
    return all;
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) ADD_FAILURE() << "no " << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

// A shape once more, by a MAPPED_ITEM with a CARTESIAN_TRANSFORMATION_OPERATOR_3D.
inline std::string mapped(const std::string& operatorText, Shape of = Shape::Box) {
    std::string text = cad_files::step(of);
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
