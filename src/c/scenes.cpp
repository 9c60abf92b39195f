#include <span>

#include <inkedge/load_scene.h>
#include <inkedge/scene_arrays.h>
#include <inkedge/views.h>

#include "c/handles.h"

namespace inkedge::c {
namespace {

ArrayView viewOf(const inkedge_array& array) {
    return {array.data,         static_cast<NumberType>(array.type), array.rows, array.columns, array.row_stride,
            array.column_stride};
}
static_assert(static_cast<int>(NumberType::Float32) == INKEDGE_FLOAT32 &&
              static_cast<int>(NumberType::Float64) == INKEDGE_FLOAT64 &&
              static_cast<int>(NumberType::UInt8) == INKEDGE_UINT8 &&
              static_cast<int>(NumberType::UInt16) == INKEDGE_UINT16 &&
              static_cast<int>(NumberType::UInt32) == INKEDGE_UINT32 &&
              static_cast<int>(NumberType::UInt64) == INKEDGE_UINT64 &&
              static_cast<int>(NumberType::Int32) == INKEDGE_INT32 &&
              static_cast<int>(NumberType::Int64) == INKEDGE_INT64);

InstancedArrays arraysOf(const inkedge_mesh& mesh) {
    InstancedArrays arrays;
    if (mesh.name != nullptr) arrays.mesh.name = mesh.name;
    arrays.mesh.positions = viewOf(mesh.positions);
    arrays.mesh.indices = viewOf(mesh.indices);
    arrays.mesh.normals = viewOf(mesh.normals);
    arrays.mesh.textureCoordinates = viewOf(mesh.texture_coordinates);
    arrays.mesh.colors = viewOf(mesh.colors);
    arrays.transforms = viewOf(mesh.transforms);
    const std::size_t instances = std::max<std::size_t>(mesh.transforms.rows, 1);
    for (std::size_t i = 0; mesh.names != nullptr && i < instances; ++i)
        arrays.names.emplace_back(&given(mesh.names[i], "names"));
    return arrays;
}

}  // namespace
}  // namespace inkedge::c

using namespace inkedge::c;

inkedge_status inkedge_scene_load(const char* file, const inkedge_settings* settings, inkedge_scene** scene) {
    return handOut(scene, [&] {
        return new inkedge_scene{
            inkedge::loadScene(&given(file, "file"), inkedge::loadSettings(valueOf(settings), {}))};
    });
}

inkedge_status inkedge_scene_read(const void* bytes, size_t size, const char* name, const inkedge_settings* settings,
                                  inkedge_scene** scene) {
    return handOut(scene, [&] {
        if (size > 0 && bytes == nullptr)
            throw inkedge::Error{inkedge::Error::Kind::Usage, "bytes: expected some, found NULL"};
        const std::span content{static_cast<const std::uint8_t*>(bytes), size};
        return new inkedge_scene{
            inkedge::loadScene(content, name == nullptr ? "" : name, inkedge::loadSettings(valueOf(settings), {}))};
    });
}

inkedge_status inkedge_scene_make(const inkedge_mesh* meshes, size_t count, const inkedge_settings* settings,
                                  inkedge_scene** scene) {
    return handOut(scene, [&] {
        std::vector<inkedge::InstancedArrays> arrays;
        if (count > 0) (void)given(meshes, "meshes");
        for (std::size_t i = 0; i < count; ++i) arrays.push_back(arraysOf(meshes[i]));
        return new inkedge_scene{inkedge::makeScene(arrays, inkedge::loadSettings(valueOf(settings), {}))};
    });
}

void inkedge_scene_free(inkedge_scene* scene) { delete scene; }

uint64_t inkedge_scene_triangles(const inkedge_scene* scene) { return scene->value.triangleCount(); }

void inkedge_scene_box(const inkedge_scene* scene, double box[6]) {
    for (int axis = 0; axis < 3; ++axis) {
        box[axis] = scene->value.box().min[axis];
        box[3 + axis] = scene->value.box().max[axis];
    }
}

const char* inkedge_scene_warning(const inkedge_scene* scene, size_t index) {
    const auto& warnings = scene->value.warnings();
    return index < warnings.size() ? warnings[index].c_str() : nullptr;
}
