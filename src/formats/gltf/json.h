#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

/// Reading a glTF document that nobody has checked.
namespace inkedge::gltf {

using Json = nlohmann::json;

/// A value as text for a message.
[[nodiscard]] std::string found(const Json&);

/// A member of an object; null if there is none, or object is no object.
[[nodiscard]] const Json& member(const Json& object, const char* key);

/// @param otherwise  the value if the member is missing; none: it must not be missing
/// @throws Error     (Kind::Input) if the member is no number of at least 0, or is missing and must not be
[[nodiscard]] std::uint64_t number(const Json& object, const char* key, std::optional<std::uint64_t> otherwise = {});

/// @param otherwise  the text if the member is missing
/// @throws Error     (Kind::Input) if the member is no string
[[nodiscard]] std::string text(const Json& object, const char* key, const char* otherwise);

/// An object's extension; null if it has none of that name.
[[nodiscard]] const Json& extension(const Json& object, const char* name);

/// A list's length; 0 if it is no list.
[[nodiscard]] std::size_t sizeOf(const Json& list);

/// An entry of a list of the document.
/// @throws Error  (Kind::Input) if the index is out of range
[[nodiscard]] const Json& entry(const Json& document, const char* list, std::uint64_t index);

}  // namespace inkedge::gltf
