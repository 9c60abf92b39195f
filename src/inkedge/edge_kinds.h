#pragma once

#include <cstdint>

namespace inkedge {

/// What a file says of the edge between two triangles.
enum class EdgeKind : std::uint8_t {
    /// The edge only cuts a polygon of the file into triangles. If both triangles of the edge say so the edge is no
    /// crease, however the polygon bends there.
    Inner = 1U << 0U,
    /// A crease, however little the triangles bend there.
    Sharp = 1U << 1U,
    /// Two faces of the file go on into each other there: no crease, however the triangles bend, but LineType::Tangent.
    Tangent = 1U << 2U,
    /// Within a face of the file, or where it meets itself, as the side of a cylinder does, or another part of the same
    /// surface: no line, however the triangles bend.
    Seam = 1U << 3U,
    /// No other face of the file shares the edge: the surface ends there. Where another surface touches the edge, the
    /// angle between the two surfaces decides whether a line is drawn, as everywhere.
    Free = 1U << 4U,
    /// Meant to be drawn as a line (LineType::Marked).
    Marked = 1U << 5U,
};

/// A set of EdgeKind.
class EdgeKinds {
public:
    constexpr EdgeKinds() noexcept = default;
    constexpr EdgeKinds(EdgeKind kind) noexcept : bits_{static_cast<std::uint8_t>(kind)} {}

    [[nodiscard]] constexpr bool has(EdgeKind kind) const noexcept {
        return (bits_ & static_cast<std::uint8_t>(kind)) != 0;
    }
    [[nodiscard]] constexpr bool empty() const noexcept { return bits_ == 0; }
    constexpr EdgeKinds& operator|=(EdgeKinds other) noexcept {
        bits_ = static_cast<std::uint8_t>(bits_ | other.bits_);
        return *this;
    }
    /// This set without the other's kinds.
    constexpr EdgeKinds& operator-=(EdgeKinds other) noexcept {
        bits_ = static_cast<std::uint8_t>(bits_ & ~other.bits_);
        return *this;
    }
    friend constexpr EdgeKinds operator|(EdgeKinds a, EdgeKinds b) noexcept { return a |= b; }
    friend constexpr EdgeKinds operator-(EdgeKinds a, EdgeKinds b) noexcept { return a -= b; }
    friend constexpr bool operator==(EdgeKinds, EdgeKinds) noexcept = default;

private:
    std::uint8_t bits_ = 0;
};

constexpr EdgeKinds operator|(EdgeKind a, EdgeKind b) noexcept { return EdgeKinds{a} | EdgeKinds{b}; }

}  // namespace inkedge
