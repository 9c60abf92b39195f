#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/scene.h>

#include "lines/segment.h"

namespace inkedge::lines {

/// The pieces of a mesh's lines, each once, as the indices of their ends in Mesh::lines: of ends at one position the
/// first one's. Pieces of no length are left out.
using FileLines = std::vector<std::array<std::uint32_t, 2>>;

/// O(n log n).
[[nodiscard]] FileLines findFileLines(const Mesh&);

/// Adds the lines of all instances. They hide nothing. A face hides them if it is nearer than they are by over half a
/// pixel's footprint: lines of files run along the edges of faces, and within them.
/// @param ofMeshes  one per mesh
void addFileLines(const Scene&, std::span<const FileLines> ofMeshes, std::vector<Segment>& to);

}  // namespace inkedge::lines
