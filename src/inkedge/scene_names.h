#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include <inkedge/export.h>

namespace inkedge {

class Scene;

/// What an id of an instance stands for.
struct NamedInstance {
    std::uint32_t id = 0;  ///< as in Maps::ids and Line::object: instances that are drawn, counted from 1
    /// Names from a root of the file's tree to the instance's node, as in "crane/arm/hook"; nodes without a name are
    /// left out, and an instance's own that has none has its mesh's. Over 1024 bytes what comes first becomes "...".
    std::string node;
    std::string mesh;                      ///< its name; may be empty
    std::vector<std::uint32_t> materials;  ///< ids of its triangles' materials, each once, rising; 0 is none of them
    glm::dmat4 transform{1.0};             ///< mesh space -> world, as the file has it
    friend bool operator==(const NamedInstance&, const NamedInstance&) = default;
};

/// What the ids of a scene stand for.
struct SceneNames {
    std::vector<NamedInstance> instances;  ///< ids rising
    std::vector<std::string> materials;    ///< of all materials of the file: id 1 comes first; may be empty texts
    friend bool operator==(const SceneNames&, const SceneNames&) = default;
};

/// The names of everything drawn.
[[nodiscard]] INKEDGE_API SceneNames namesOf(const Scene&);

}  // namespace inkedge
