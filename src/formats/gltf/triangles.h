#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace inkedge::gltf {

/// primitive.mode
enum class Mode : int { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

/// The name of a mode: "TRIANGLE_STRIP".
/// @throws Error  (Kind::Input) if glTF has no such mode
[[nodiscard]] std::string_view name(Mode);

[[nodiscard]] constexpr bool drawsTriangles(Mode mode) noexcept { return mode >= Mode::Triangles; }
[[nodiscard]] constexpr bool drawsLines(Mode mode) noexcept { return mode > Mode::Points && mode < Mode::Triangles; }

/// Whether each corner of a mode goes on from those before it, so that a restart means something.
[[nodiscard]] constexpr bool isContinued(Mode mode) noexcept {
    return mode == Mode::LineLoop || mode == Mode::LineStrip || mode > Mode::Triangles;
}

/// Stands between the corners of two strips, fans or loops of one primitive: primitive restart.
inline constexpr std::uint32_t restart = 0xffff'ffff;

/// The corners between restarts, without those that have none.
[[nodiscard]] std::vector<std::span<const std::uint32_t>> runsOf(std::span<const std::uint32_t> corners);

/// The triangles of a primitive, three indices each, wound as glTF 2.0, section 3.7.2.1, prescribes. Triangles with a
/// repeated index, as strips are joined with, are left out.
/// @param mode     one that draws triangles
/// @param corners  the primitive's vertex indices in the order of the file, and restarts; a rest too short for a
///                 triangle is not used
[[nodiscard]] std::vector<std::uint32_t> triangleList(Mode mode, std::vector<std::uint32_t> corners);

/// For each triangle of triangleList() its index among all triangles of the primitive, those left out included.
[[nodiscard]] std::vector<std::uint32_t> triangleNumbers(Mode mode, std::span<const std::uint32_t> corners);

/// How many triangles a primitive has, those left out included.
[[nodiscard]] std::size_t triangleCount(Mode mode, std::span<const std::uint32_t> corners);

}  // namespace inkedge::gltf
