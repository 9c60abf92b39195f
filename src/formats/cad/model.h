#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "formats/cad/surface_data.h"

// What the program that reads CAD files, and the library that asked for it, say to each other. Millimetres.
namespace inkedge::cad {

/// A part where it stands in the assembly.
struct Instance {
    std::string name;
    std::uint32_t part = 0;
    std::uint32_t node = 0;
    glm::dmat4 transform{1.0};
};

/// The program says first, and again when it has a better idea, what is where.
struct Outline {
    std::string failure = {};                    ///< why there is nothing; empty: there is
    bool ready = false;                          ///< the model follows, nothing is asked
    std::vector<std::vector<glm::dvec3>> parts;  ///< points around, or on, each part
    std::vector<Instance> instances;
};

/// The answer: how fine the parts are to be.
struct Fineness {
    std::vector<double> deflections;  ///< one per part: how far triangles may stray from the surface
};

struct Node {
    std::string name;
    std::uint32_t parent = 0;  ///< noNode: a root
};

struct Material {
    std::string name;
    glm::vec4 color{1.0F};  ///< linear
};

/// As the members of Mesh. A part is a solid, or faces by themselves.
struct Part {
    std::string name;
    glm::dvec3 origin{0.0};
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::dvec2> parameters;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> materials;
    std::vector<std::uint8_t> edges;  ///< a bit set of EdgeKind each
    std::vector<SurfaceData> surfaces;
};

struct Model {
    std::vector<Part> parts;
    std::vector<Instance> instances;
    std::vector<Node> nodes;
    std::vector<Material> materials;
    std::vector<std::string> warnings;
    std::vector<std::string> undrawn;  ///< as Scene::Data
};

// Lists the members of each structure for formats/cad/pack.h.

template <class Archive>
void members(Archive& archive, Instance& i) {
    archive(i.name, i.part, i.node, i.transform);
}
template <class Archive>
void members(Archive& archive, Outline& o) {
    archive(o.failure, o.ready, o.parts, o.instances);
}
template <class Archive>
void members(Archive& archive, Fineness& f) {
    archive(f.deflections);
}
template <class Archive>
void members(Archive& archive, Node& n) {
    archive(n.name, n.parent);
}
template <class Archive>
void members(Archive& archive, Material& m) {
    archive(m.name, m.color);
}
template <class Archive>
void members(Archive& archive, Part& p) {
    archive(p.name, p.origin, p.positions, p.normals, p.parameters, p.indices, p.faces, p.materials, p.edges,
            p.surfaces);
}
template <class Archive>
void members(Archive& archive, Model& m) {
    archive(m.parts, m.instances, m.nodes, m.materials, m.warnings, m.undrawn);
}

}  // namespace inkedge::cad
