#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <inkedge/scene.h>

#include "formats/gltf/model.h"

namespace inkedge::gltf {

/// Triangles and lines as the file has them, before Mesh::origin is subtracted.
struct Shape {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  ///< as many; (0, 0, 0) where the file has none
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> materials;  ///< one per triangle; 0: none
    std::vector<glm::vec2> coordinates;    ///< one per position, or none
    std::vector<VertexPaint> paint;        ///< likewise
    std::vector<EdgeKinds> edges;          ///< one per index, or none: Mesh::edges
    std::vector<glm::dvec3> lines;         ///< Mesh::lines
    bool authored = false;                 ///< whether any normal is the file's
};

/// How morph targets and skins change a mesh.
struct Pose {
    std::vector<double> weights;     ///< of the morph targets; empty: none is on
    std::vector<glm::dmat4> joints;  ///< joint -> world; empty: no skin
};

/// Moves a primitive's vertices by its morph targets.
/// @throws Error  (Kind::Input) if a target does not fit
void morph(const tinygltf::Model&, const tinygltf::Primitive&, const std::vector<double>& weights, Shape& part);

/// Moves a primitive's vertices by their joints: glTF 2.0, section 3.7.3.3.
/// @throws Error  (Kind::Input) if joints or weights are missing or do not fit
void skin(const tinygltf::Model&, const tinygltf::Primitive&, const std::vector<glm::dmat4>& joints, Shape& part);

/// @throws Error  (Kind::Input) if a position is not finite as a float
void checkPositions(const std::vector<glm::dvec3>&);

/// Scales normals to length 1; those without a direction become (0, 0, 0).
void normalize(std::vector<glm::dvec3>& normals);

/// Adds the triangles and lines of a primitive to those of its mesh.
void append(Shape&, Shape part);

[[nodiscard]] Mesh meshOf(Shape, const std::string& name);

}  // namespace inkedge::gltf
