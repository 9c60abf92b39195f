#pragma once

#include <inkedge/scene.h>

#include "formats/model_input.h"

namespace inkedge::gltf {

/// Reads a scene of a glTF 2.0 file, .glb or .gltf by its content. External buffers are read only from the model's own
/// folder, which a model in memory does not have. The triangles of a mesh (lists, strips and fans) become one triangle
/// list. Morph targets have their default weights and skins their default pose unless an animation is set. Materials of
/// alpha mode MASK are cut out along their outline. Data compressed with KHR_draco_mesh_compression or
/// EXT_meshopt_compression are read if the build has the libraries for it. Nodes hidden by KHR_node_visibility are left
/// out.
///
/// Normals are the file's, unit length, (0, 0, 0) where it has none; a mesh without any has no normals at all. Lines
/// are those of primitives of lines, and edges that an extension marks without a triangle. Points are left out with one
/// warning. A file without triangles and lines gives no meshes and no instances.
///
/// @throws Error  (Kind::Input) if the file is missing, unreadable, over the limits, no glTF 2.0, truncated or
///                inconsistent, or needs an extension that is not read; (Kind::Usage) if it has no scene or animation
///                as set; the message starts with the name as given
/// Thread-safe.
[[nodiscard]] Scene::Data loadGltf(const formats::ModelInput&, const LoadSettings& settings = {});

}  // namespace inkedge::gltf
