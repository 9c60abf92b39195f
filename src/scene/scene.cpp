#include <inkedge/scene.h>

#include <utility>

#include <glm/geometric.hpp>

#include "scene/prepare.h"
#include "scene/prepared.h"

namespace inkedge {

Scene::Scene(Data data, const LoadSettings& settings)
    : prepared_{std::make_shared<const PreparedScene>(scene::prepare(std::move(data), settings))} {}

const std::vector<Mesh>& Scene::meshes() const noexcept { return prepared_->data.meshes; }
const std::vector<Instance>& Scene::instances() const noexcept { return prepared_->data.instances; }
const std::vector<SceneNode>& Scene::nodes() const noexcept { return prepared_->data.nodes; }
const std::vector<SceneCamera>& Scene::cameras() const noexcept { return prepared_->data.cameras; }
const std::vector<Material>& Scene::materials() const noexcept { return prepared_->data.materials; }
const std::vector<std::string>& Scene::warnings() const noexcept { return prepared_->data.warnings; }
const SceneSource& Scene::source() const noexcept { return prepared_->data.source; }
const Box& Scene::meshBox(std::size_t i) const noexcept { return prepared_->meshBoxes[i]; }
const Box& Scene::box() const noexcept { return prepared_->box; }
const Sphere& Scene::bounds() const noexcept { return prepared_->bounds; }
const LoadSettings& Scene::loadedWith() const noexcept { return prepared_->loadedWith; }
glm::dvec3 Scene::up() const noexcept {
    return glm::normalize(prepared_->loadedWith.up.value_or(prepared_->data.source.up));
}
glm::dvec3 Scene::front() const noexcept {
    const glm::dvec3 up = this->up();
    if (up.y <= -1.0) return {0.0, 0.0, 1.0};  // no way is the shortest
    // +Z, turned by the rotation that takes +Y to up; +Y x up is its axis, times its sine.
    const glm::dvec3 axis{up.z, 0.0, -up.x};
    const glm::dvec3 front{0.0, 0.0, 1.0};
    return up.y * front + glm::cross(axis, front) + axis * (glm::dot(axis, front) / (1.0 + up.y));
}
double Scene::creaseAngle() const noexcept { return prepared_->loadedWith.creaseAngle; }
std::uint64_t Scene::triangleCount() const noexcept { return prepared_->triangleCount; }
double Scene::preparationMilliseconds() const noexcept { return prepared_->milliseconds; }

const std::shared_ptr<const PreparedScene>& preparedOf(const Scene& scene) noexcept { return scene.prepared_; }

}  // namespace inkedge
