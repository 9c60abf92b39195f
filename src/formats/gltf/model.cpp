#define TINYGLTF_IMPLEMENTATION
#include "formats/gltf/model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/type_ptr.hpp>

namespace inkedge::gltf {

namespace {

using Buffers = std::vector<std::vector<std::uint8_t>>;

// tinygltf 2.9 has a callback for the size of a file, 2.7 has not.
template <class Callbacks>
void serveSizes(Callbacks& served) {
    if constexpr (requires { served.GetFileSizeInBytes; }) {
        served.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string& name, void* all) {
            *size = static_cast<const Buffers*>(all)->at(std::stoul(name)).size();
            return true;
        };
    }
}

// Lets tinygltf reach no file: a buffer's uri is its number among those already read.
tinygltf::FsCallbacks servedFrom(Buffers& buffers) {
    const auto exists = [](const std::string&, void*) { return true; };
    const auto expand = [](const std::string& name, void*) { return name; };
    const auto read = [](std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* all) {
        *bytes = std::move(static_cast<Buffers*>(all)->at(std::stoul(name)));
        return true;
    };
    // Newer versions also ask for a size, and read nothing unless all callbacks are set, even that for writing.
    tinygltf::FsCallbacks served{};
    served.FileExists = exists;
    served.ExpandFilePath = expand;
    served.ReadWholeFile = read;
    served.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    serveSizes(served);
    served.user_data = &buffers;
    return served;
}

// The first line of tinygltf's errors that is an error: that a skin has no inverse bind matrices is none.
std::string firstError(std::string_view errors) {
    while (!errors.empty()) {
        const std::string_view line = errors.substr(0, errors.find('\n'));
        if (!line.empty() && !line.starts_with("'inverseBindMatrices' property is missing"))
            return base::printable(line.substr(0, 300));
        errors.remove_prefix(std::min(errors.size(), line.size() + 1));
    }
    return {};
}

Elements elementsOf(const tinygltf::Model& model, int bufferView, std::uint64_t offset, std::uint64_t stride) {
    const tinygltf::BufferView& view = at(model.bufferViews, bufferView, "a bufferView");
    return base::within(base::label("bufferView", static_cast<std::size_t>(bufferView)), [&] {
        const tinygltf::Buffer& buffer = at(model.buffers, view.buffer, "a buffer");
        return Elements{slice(buffer.data, view.byteOffset, view.byteLength), offset, stride};
    });
}

ElementType elementType(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return scalar;
        case TINYGLTF_TYPE_VEC2:
            return vec2;
        case TINYGLTF_TYPE_VEC3:
            return vec3;
        case TINYGLTF_TYPE_VEC4:
            return vec4;
        case TINYGLTF_TYPE_MAT2:
            return {"MAT2", 4};
        case TINYGLTF_TYPE_MAT3:
            return {"MAT3", 9};
        default:
            return mat4;
    }
}

// A small file must not take much memory: an accessor without data has at most as many elements as the buffers bytes.
void checkBare(const tinygltf::Model& model, std::uint64_t count) {
    std::uint64_t bytes = 1U << 16U;
    for (const tinygltf::Buffer& buffer : model.buffers) bytes = std::max<std::uint64_t>(bytes, buffer.data.size());
    if (count > bytes) base::refuse(fmt::format("expected at most {} elements without data, found {}", bytes, count));
}

// The file's numbers have been checked to be at least 0.
Accessor describe(const tinygltf::Model& model, const tinygltf::Accessor& source) {
    Accessor accessor{
        elementType(source.type), Component{source.componentType}, source.normalized, source.count, {}, {}};
    if (source.bufferView == -1) checkBare(model, source.count);
    if (source.bufferView != -1) {
        const std::uint64_t stride = at(model.bufferViews, source.bufferView, "a bufferView").byteStride;
        accessor.elements = elementsOf(model, source.bufferView, source.byteOffset, stride);
    }
    if (source.sparse.isSparse) {
        const auto& indices = source.sparse.indices;
        const auto& values = source.sparse.values;
        accessor.sparse =
            Accessor::Sparse{static_cast<std::uint64_t>(source.sparse.count), Component{indices.componentType},
                             elementsOf(model, indices.bufferView, static_cast<std::uint64_t>(indices.byteOffset), 0),
                             elementsOf(model, values.bufferView, static_cast<std::uint64_t>(values.byteOffset), 0)};
    }
    return accessor;
}

// Puts the name and the use of an accessor before the message of an error.
template <class Read>
auto withAccessor(const tinygltf::Model& model, int index, std::string_view use, Read&& read) {
    return base::within(std::string{use}, [&] {
        const tinygltf::Accessor& source = at(model.accessors, index, "an accessor");
        return base::within(base::label("accessor", static_cast<std::size_t>(index)),
                            [&] { return read(describe(model, source)); });
    });
}

}  // namespace

tinygltf::Model parse(std::string json, Buffers buffers) {
    if (json.size() > std::numeric_limits<unsigned int>::max())
        base::refuse(fmt::format("expected less than 4 GiB of JSON, found {} bytes", json.size()));
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(servedFrom(buffers));
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    const bool parsed =
        parser.LoadASCIIFromString(&model, &errors, &warnings, json.data(), static_cast<unsigned int>(json.size()), "");
    // tinygltf reports some errors, but succeeds without the element.
    const std::string error = firstError(errors);
    if (!parsed || !error.empty()) base::refuse("expected glTF 2.0, found: " + error);
    return model;
}

const tinygltf::Value& member(const tinygltf::Value& object, const char* key) {
    static const tinygltf::Value none;
    return object.IsObject() ? object.Get(key) : none;
}

std::string nodeLabel(const tinygltf::Model& model, std::size_t node) {
    return base::label("node", node, model.nodes[node].name);
}

bool finite(const glm::dmat4& matrix) {
    return std::all_of(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16, [](double x) { return std::isfinite(x); });
}

std::span<const std::uint8_t> viewBytes(const tinygltf::Model& model, int bufferView) {
    return elementsOf(model, bufferView, 0, 0).bytes;
}

std::vector<double> readNumbers(const tinygltf::Model& model, int accessor, std::string_view use,
                                const Expected& expected) {
    return withAccessor(model, accessor, use,
                        [&](const Accessor& description) { return readNumbers(description, expected); });
}

std::vector<std::uint32_t> readIndices(const tinygltf::Model& model, int accessor, std::uint64_t vertexCount,
                                       Restarts restarts) {
    return withAccessor(model, accessor, "indices",
                        [&](const Accessor& description) { return readIndices(description, vertexCount, restarts); });
}

std::uint64_t elementCount(const tinygltf::Model& model, int accessor, std::string_view use) {
    return base::within(std::string{use}, [&] { return at(model.accessors, accessor, "an accessor").count; });
}

}  // namespace inkedge::gltf
