#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// tiny_gltf.h needs it but leaves it out with TINYGLTF_NO_FS
#include <fstream>

#include <fmt/format.h>
#include <glm/mat4x4.hpp>

#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include "base/message.h"
#include "formats/gltf/accessor.h"
#include "formats/gltf/file.h"

/// Reads tinygltf's model, whose indices and sizes nobody has checked, with checks.
namespace inkedge::gltf {

/// @throws Error  (Kind::Input) if tinygltf does not take the text for glTF 2.0
[[nodiscard]] tinygltf::Model parse(std::string json, std::vector<std::vector<std::uint8_t>> buffers);

/// @throws Error  (Kind::Input) if the index is out of range
template <class T>
const T& at(const std::vector<T>& all, int index, std::string_view kind) {
    if (index < 0 || static_cast<std::size_t>(index) >= all.size())
        base::refuse(fmt::format("expected {} below {}, found {}", kind, all.size(), index));
    return all[static_cast<std::size_t>(index)];
}

/// A member of an object; null if there is none, or object is no object, for which tinygltf's own Get() must not be
/// called.
[[nodiscard]] const tinygltf::Value& member(const tinygltf::Value& object, const char* key);

[[nodiscard]] std::string nodeLabel(const tinygltf::Model&, std::size_t node);

[[nodiscard]] bool finite(const glm::dmat4&);

/// The bytes of a bufferView.
/// @throws Error  (Kind::Input) if the bufferView does not lie within its buffer
[[nodiscard]] std::span<const std::uint8_t> viewBytes(const tinygltf::Model&, int bufferView);

/// gltf::readNumbers() of an accessor of the model. Errors name the accessor and its use ("POSITION"). An accessor
/// without data may have no more elements than the buffers have bytes, so that a small file cannot take much memory.
[[nodiscard]] std::vector<double> readNumbers(const tinygltf::Model&, int accessor, std::string_view use,
                                              const Expected&);

/// gltf::readIndices() likewise.
[[nodiscard]] std::vector<std::uint32_t> readIndices(const tinygltf::Model&, int accessor, std::uint64_t vertexCount,
                                                     Restarts);

/// How many elements an accessor says it has.
[[nodiscard]] std::uint64_t elementCount(const tinygltf::Model&, int accessor, std::string_view use);

template <class Vector>
std::vector<Vector> readVectors(const tinygltf::Model& model, int accessor, std::string_view use,
                                const Expected& expected) {
    constexpr std::size_t components = static_cast<std::size_t>(Vector::length());
    const std::vector<double> numbers = readNumbers(model, accessor, use, expected);
    std::vector<Vector> vectors(numbers.size() / components);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        vectors[i / components][static_cast<int>(i % components)] = numbers[i];
    return vectors;
}

/// The vectors of an attribute, one per vertex; empty if the attribute is missing.
template <class Vector>
std::vector<Vector> readAttribute(const tinygltf::Model& model, const std::map<std::string, int>& attributes,
                                  const std::string& name, const Expected& expected, std::size_t count) {
    const auto attribute = attributes.find(name);
    if (attribute == attributes.end()) return {};
    std::vector<Vector> vectors = readVectors<Vector>(model, attribute->second, name, expected);
    if (vectors.size() != count)
        base::refuse(
            fmt::format("{}: expected as many elements as POSITION has, {}, found {}", name, count, vectors.size()));
    return vectors;
}

}  // namespace inkedge::gltf
