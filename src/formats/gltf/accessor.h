#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace inkedge::gltf {

/// accessor.componentType
enum class Component : int { Int8 = 5120, Uint8 = 5121, Int16 = 5122, Uint16 = 5123, Uint32 = 5125, Float = 5126 };

/// accessor.type
struct ElementType {
    std::string_view name;
    std::uint64_t components = 0;
    friend bool operator==(const ElementType&, const ElementType&) = default;
};
inline constexpr ElementType scalar{"SCALAR", 1};
inline constexpr ElementType vec2{"VEC2", 2};
inline constexpr ElementType vec3{"VEC3", 3};
inline constexpr ElementType vec4{"VEC4", 4};
inline constexpr ElementType mat4{"MAT4", 16};

/// Elements in a bufferView. Nothing is checked until they are read.
struct Elements {
    std::span<const std::uint8_t> bytes;  ///< the bufferView's
    std::uint64_t offset = 0;             ///< of the first element, bytes
    std::uint64_t stride = 0;             ///< from element to element, bytes; 0: tightly packed
};

/// An accessor as the file describes it, unchecked.
struct Accessor {
    struct Sparse {
        std::uint64_t count = 0;
        Component indexComponent = Component::Uint32;
        Elements indices;
        Elements values;
    };
    ElementType type;
    Component component = Component::Float;
    bool normalized = false;
    std::uint64_t count = 0;
    std::optional<Elements> elements;  ///< none: zeros
    std::optional<Sparse> sparse;
};

/// The types that a use of an accessor allows.
struct Expected {
    ElementType type;
    std::initializer_list<Component> components;
};

/// A part of a buffer.
/// @throws Error  (Kind::Input) if the part does not lie within the buffer
[[nodiscard]] std::span<const std::uint8_t> slice(std::span<const std::uint8_t> buffer, std::uint64_t offset,
                                                  std::uint64_t length);

/// Reads count x components numbers, element by element. Normalized integers become -1..1 or 0..1. Sparse values are
/// applied.
/// @throws Error  (Kind::Input) if the accessor is not as expected, has over 2^28 elements, reaches beyond its bytes,
///                or a sparse index is out of range
[[nodiscard]] std::vector<double> readNumbers(const Accessor&, const Expected&);

/// What the component type's largest value means as an index: glTF reserves it for primitive restart.
enum class Restarts { Refused, Read };

/// Reads the vertex indices of a primitive, restarts as `restart` of triangles.h.
/// @throws Error  (Kind::Input) as readNumbers(); if an index is not below vertexCount, or a restart that is refused
[[nodiscard]] std::vector<std::uint32_t> readIndices(const Accessor&, std::uint64_t vertexCount, Restarts);

}  // namespace inkedge::gltf
