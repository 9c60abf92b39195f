#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include <inkedge/export.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge {

/// A format that models are read from.
struct ModelFormat {
    std::string_view name;                         ///< as in SceneSource::format: "glTF 2.0"
    std::span<const std::string_view> extensions;  ///< of its files, in lower case: ".glb"
};

/// Every format that loadScene() reads, in the order of the manual.
[[nodiscard]] INKEDGE_API std::span<const ModelFormat> readableFormats() noexcept;

/// Reads a model of one of readableFormats(). Its extension says which, in whatever case; where it is none of theirs,
/// the first bytes do. An OBJ, STL or PLY file becomes one mesh. Draco and meshopt compression of glTF are read.
/// @throws Error  (Kind::Input) if it is missing, in another format, truncated or inconsistent, or draws nothing;
///                (Kind::Usage) if validate() refuses a setting, or the file has no scene or animation as set
[[nodiscard]] INKEDGE_API Scene loadScene(const std::filesystem::path& file, const LoadSettings& settings = {});

/// Reads a model from memory: the scene that a file of these bytes and this name would give. A glTF must hold all its
/// data, in its binary chunk or as data URIs: there is no folder that a buffer's file could lie in. A picture in a
/// file is left out with a warning.
/// @param bytes  the file's content; needed during the call only
/// @param name   "part.ply": its extension says the format, and it names a mesh whose format does not; no file of this
///               name is looked for. Empty: the first bytes say the format, as they do of glTF, PLY and STL as text
/// @throws Error  as for a file; (Kind::Input) if there are no bytes, or a glTF names a buffer's file
[[nodiscard]] INKEDGE_API Scene loadScene(std::span<const std::uint8_t> bytes, const std::filesystem::path& name,
                                          const LoadSettings& settings = {});

}  // namespace inkedge
