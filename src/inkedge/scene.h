#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <inkedge/bounds.h>
#include <inkedge/export.h>
#include <inkedge/image.h>
#include <inkedge/mesh.h>
#include <inkedge/settings.h>

namespace inkedge {

/// What a model's file is, and what it offers to choose from.
struct SceneSource {
    std::string name = {};                ///< of the file, without its folder; empty: no file
    std::string format;                   ///< a name of readableFormats(); empty: no file
    std::vector<std::string> scenes;      ///< names, in the order of LoadSettings::scene; may be empty texts
    std::vector<std::string> animations;  ///< likewise, of LoadSettings::animation
    std::vector<std::string> extensions;  ///< of glTF, that it uses
    LengthUnit unit = LengthUnit::None;   ///< of world space: LoadSettings::unit, or the file's
    bool knowsSides = false;              ///< a surface is single-sided unless its Material says that it is not
    std::vector<std::filesystem::path> files = {};  ///< buffers and pictures that it names, as far as they are there
    glm::dvec3 up{0.0, 1.0, 0.0};                   ///< world space, unit length: what users of the format call up
};

/// What the file says of a surface.
struct Material {
    std::string name;
    bool doubleSided = true;  ///< false: its backs are not meant to be seen
    glm::vec4 color{1.0F};    ///< linear; multiplied by the picture's and the vertices' colours
    std::shared_ptr<const Image<std::uint8_t>> picture = {};  ///< sRGB, 4 channels; none: not asked for, or none
    std::array<TextureWrap, 2> wrap{TextureWrap::Repeat, TextureWrap::Repeat};  ///< of the picture, along each axis
};

/// Stands for no node, in Instance::node and SceneNode::parent.
inline constexpr std::uint32_t noNode = ~0U;

/// A node of the file's tree of names.
struct SceneNode {
    std::string name;               ///< may be empty
    std::uint32_t parent = noNode;  ///< into Scene::nodes(), before this one; noNode: a root
};

/// A mesh in the world.
struct Instance {
    std::string name;
    std::uint32_t mesh = 0;       ///< into Scene::meshes()
    glm::dmat4 transform{1.0};    ///< mesh space -> world, affine; may mirror and shear
    std::uint32_t node = noNode;  ///< into Scene::nodes(): the node that it belongs to; noNode: the file has no tree
};

/// A camera that the file brings along.
struct SceneCamera {
    std::string name;
    glm::dmat4 transform{1.0};        ///< camera space -> world; the camera looks along its -Z, its up is +Y
    double viewAngle = 35.0;          ///< vertical, degrees; perspective only
    double orthographicHeight = 0.0;  ///< scene units across the picture's height; 0: perspective
};

struct PreparedScene;  // internal

/// An immutable set of meshes, instances of them and cameras. Copies are cheap and share the data.
/// Safe to read from several threads.
class INKEDGE_API Scene {
public:
    struct Data {
        std::vector<Mesh> meshes;
        std::vector<Instance> instances;
        std::vector<SceneNode> nodes;  ///< parents before their children; may be empty
        std::vector<SceneCamera> cameras;
        std::vector<Material> materials;    ///< Mesh::materials counts them from 1; may be empty
        std::vector<std::string> warnings;  ///< one line each: what the file holds that is not drawn
        SceneSource source;
        /// What a file holds if it draws nothing: "24 points", "2 meshes that no node draws".
        std::vector<std::string> undrawn;
    };

    /// Checks the data, and makes the normals that are missing, split at settings.creaseAngle.
    /// @throws Error  (Kind::Input) if an index, a count or a coordinate is out of range or not finite, or if nothing
    ///                is drawn; the message names the mesh and the element
    explicit Scene(Data data, const LoadSettings& settings = {});

    [[nodiscard]] const std::vector<Mesh>& meshes() const noexcept;
    [[nodiscard]] const std::vector<Instance>& instances() const noexcept;
    [[nodiscard]] const std::vector<SceneNode>& nodes() const noexcept;
    [[nodiscard]] const std::vector<SceneCamera>& cameras() const noexcept;
    [[nodiscard]] const std::vector<Material>& materials() const noexcept;
    [[nodiscard]] const std::vector<std::string>& warnings() const noexcept;
    [[nodiscard]] const SceneSource& source() const noexcept;

    /// The box of mesh i's positions and lines less its origin.
    [[nodiscard]] const Box& meshBox(std::size_t i) const noexcept;
    /// The box of everything drawn, in world space.
    [[nodiscard]] const Box& box() const noexcept;
    /// Which way is up, world space, unit length: LoadSettings::up or, without it, the format's.
    [[nodiscard]] glm::dvec3 up() const noexcept;
    /// Where the front looks to, across up, world space, unit length: +Z where +Y is up, -Y where +Z is; for any other
    /// up, +Z turned with +Y the shortest way, +Z where -Y is up. What is to the right of one who sees the front is up
    /// x front: +X where +Y or +Z is up.
    [[nodiscard]] glm::dvec3 front() const noexcept;
    /// A sphere in world space around everything drawn.
    [[nodiscard]] const Sphere& bounds() const noexcept;
    /// The settings that the constructor was given.
    [[nodiscard]] const LoadSettings& loadedWith() const noexcept;
    /// Degrees: faces that meet at more than this meet in a crease.
    [[nodiscard]] double creaseAngle() const noexcept;
    /// Triangles drawn: every instance counts.
    [[nodiscard]] std::uint64_t triangleCount() const noexcept;

    /// Wall time that the constructor took: the rest of loadScene()'s time went into reading the file.
    [[nodiscard]] double preparationMilliseconds() const noexcept;

private:
    friend const std::shared_ptr<const PreparedScene>& preparedOf(const Scene&) noexcept;
    std::shared_ptr<const PreparedScene> prepared_;
};

}  // namespace inkedge
