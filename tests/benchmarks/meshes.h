#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include <inkedge/scene.h>

/// Meshes of any number of triangles, the same on every machine up to float rounding.
namespace inkedge::benchmarks {

enum class Shape {
    Cad,     ///< a closed toothed ring with square flanks: creases and flat faces; no normals
    Smooth,  ///< a closed torus with bumps; has normals
    Scan,    ///< the same without normals and with noise, its vertices and triangles in random order
};

/// @throws std::runtime_error  if the name is none of "cad", "smooth" and "scan"
[[nodiscard]] Shape shapeNamed(std::string_view name);

[[nodiscard]] std::string_view nameOf(Shape);

/// @param triangles  about how many: what is made is the nearest that the shape allows, within a tenth from 10,000 up
[[nodiscard]] Mesh makeMesh(Shape, std::uint64_t triangles);

/// Writes one mesh as a .glb file.
/// @throws std::runtime_error  if the file cannot be written
void writeGlb(const Mesh&, const std::filesystem::path& file);

}  // namespace inkedge::benchmarks
