#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/message.h"

namespace inkedge::polygons {

/// What an OBJ, STL or PLY file says of its surface and lines. Indices are not yet checked.
struct PolygonFile {
    std::vector<glm::vec3> positions;           ///< of a file of floats
    std::vector<glm::dvec3> finePositions;      ///< of a file of text or doubles: instead of positions
    std::vector<glm::vec3> normals;             ///< one per position, of any length; (0, 0, 0): none; may be empty
    std::vector<glm::vec2> textureCoordinates;  ///< one per position, v = 0 at the top; may be empty
    std::vector<std::uint32_t> corners;         ///< into positions, face after face
    std::vector<std::uint32_t> faceSizes;       ///< one per face, at least 3; empty: all are triangles
    std::vector<std::uint32_t>
        faceMaterials;  ///< one per face: from 1 in the order of first use, 0: none; empty: all 0
    std::uint64_t faceCount = 0;
    std::vector<std::uint32_t> lines;  ///< as straight pieces: into positions, two each
    std::uint64_t points = 0;          ///< left out
    std::vector<std::string> warnings;

    /// Makes the last corners a face; two are a line, and one is a point, which is left out.
    void endFace(std::uint64_t size, std::uint32_t material = 0) {
        if (size < 3) {
            if (size == 2) lines.insert(lines.end(), corners.end() - 2, corners.end());
            if (size == 1) ++points;
            corners.erase(corners.end() - static_cast<std::ptrdiff_t>(size), corners.end());
            return;
        }
        if (size != 3 && faceSizes.empty()) faceSizes.resize(faceCount, 3);
        if (size != 3 || !faceSizes.empty()) faceSizes.push_back(static_cast<std::uint32_t>(size));
        if (material != 0 && faceMaterials.empty()) faceMaterials.resize(faceCount, 0);
        if (material != 0 || !faceMaterials.empty()) faceMaterials.push_back(material);
        ++faceCount;
    }
};

/// @param count    vertices and corners, of a header or read so far
/// @throws Error   (Kind::Input) if there are more than limits.vertices
inline void expectWithin(std::uint64_t count, std::uint64_t maxElements) {
    if (count > maxElements)
        base::refuse("expected at most " + std::to_string(maxElements) +
                     " vertices and corners, found more; raise max-vertices");
}

}  // namespace inkedge::polygons
