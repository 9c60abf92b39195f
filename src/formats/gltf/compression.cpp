#include "formats/gltf/compression.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "formats/gltf/accessor.h"
#include "formats/gltf/draco.h"
#include "formats/gltf/json.h"
#include "formats/gltf/meshopt.h"
#include "formats/gltf/triangles.h"

namespace inkedge::gltf {

namespace {

using Bytes = std::vector<std::uint8_t>;

// Both say the same in the same words; KHR has a further filter and version of its codec, which EXT's writers use, too.
constexpr std::array<const char*, 2> meshopts{"KHR_meshopt_compression", "EXT_meshopt_compression"};
constexpr const char* draco = "KHR_draco_mesh_compression";

const modules::Module& moduleOf(std::string_view extension) {
    return extension == draco ? static_cast<const modules::Module&>(dracoModule) : meshoptModule;
}

bool readsMeshopt() { return readsCompression(meshopts.front()); }

// The extension of these that a bufferView or a buffer has; null: none.
const char* meshoptOf(const Json& object) {
    const auto found =
        std::ranges::find_if(meshopts, [&](const char* name) { return !extension(object, name).is_null(); });
    return found == meshopts.end() ? nullptr : *found;
}

// ---- the work

class Decompression {
public:
    Decompression(Json& document, std::vector<Bytes>& buffers, std::uint64_t maxBytes)
        : document_{document}, buffers_{buffers}, bytesLeft_{maxBytes} {}

    void run() {
        const std::size_t views = sizeOf(member(document_, "bufferViews"));
        for (std::size_t i = 0; i < views; ++i)
            base::within(base::label("bufferView", i), [&] { readMeshopt(document_["bufferViews"][i]); });
        const std::size_t meshes = sizeOf(member(document_, "meshes"));
        for (std::size_t i = 0; i < meshes; ++i) readMesh(i);
    }

private:
    // ---- KHR_meshopt_compression and EXT_meshopt_compression

    void readMeshopt(Json& view) {
        const char* const name = meshoptOf(view);
        if (name == nullptr || !readsMeshopt()) {
            if (liesInFallback(view)) base::refuse("expected data of its own, found a buffer that stands in for some");
            return;
        }
        Bytes bytes = base::within(name, [&] { return decoded(extension(view, name)); });
        if (const std::uint64_t length = number(view, "byteLength"); length != bytes.size())
            base::refuse(fmt::format("expected a byteLength of {} as {} gives, found {}", bytes.size(), name, length));
        view["buffer"] = addBuffer(std::move(bytes));
        view.erase("byteOffset");
        view.erase("extensions");
    }

    Bytes decoded(const Json& compressed) {
        const MeshoptData view{number(compressed, "count"), number(compressed, "byteStride"),
                               text(compressed, "mode", ""), text(compressed, "filter", "NONE")};
        Bytes bytes = decodeMeshopt(view, bytesOf(compressed), bytesLeft_);
        bytesLeft_ -= bytes.size();
        return bytes;
    }

    // ---- KHR_draco_mesh_compression

    void readMesh(std::size_t mesh) {
        const Json& source = document_["meshes"][mesh];
        const std::size_t primitives = sizeOf(member(source, "primitives"));
        for (std::size_t i = 0; i < primitives; ++i) {
            Json& primitive = document_["meshes"][mesh]["primitives"][i];
            if (extension(primitive, draco).is_null()) continue;
            base::within(base::label("mesh", mesh, text(source, "name", "")) + ", " + base::label("primitive", i),
                         [&] { readPrimitive(primitive); });
        }
    }

    // Primitives with the same data and the same attributes share the decompressed data.
    void readPrimitive(Json& primitive) {
        if (!readsCompression(draco)) return checkPlainData(primitive);
        const Mode mode{static_cast<int>(number(primitive, "mode", static_cast<std::uint64_t>(Mode::Triangles)))};
        if (!drawsTriangles(mode)) return;
        const Json same =
            Json::array({extension(primitive, draco), primitive["attributes"], member(primitive, "indices"), mode});
        auto known = plain_.find(same);
        if (known == plain_.end())
            known = plain_.emplace(same, base::within(draco, [&] { return plainForm(primitive, mode); })).first;
        primitive.update(known->second);
        primitive.erase("extensions");
    }

    // The members of a primitive without the extension.
    Json plainForm(const Json& primitive, Mode mode) {
        if (mode == Mode::TriangleFan) base::refuse("expected mode TRIANGLES or TRIANGLE_STRIP, found TRIANGLE_FAN");
        const Json& compressed = extension(primitive, draco);
        const Json& ids = member(compressed, "attributes");
        if (!ids.is_object()) base::refuse("expected attributes, found " + found(ids));

        DracoExpected expected;
        for (const auto& [name, id] : ids.items()) expected.attributes.push_back(attributeId(name, id));
        if (mode == Mode::Triangles && primitive.contains("indices"))
            expected.triangleCount = number(entry(document_, "accessors", number(primitive, "indices")), "count") / 3;
        DracoMesh mesh = decodeDraco(bytesOfView(number(compressed, "bufferView")), expected, bytesLeft_);

        Json attributes = primitive["attributes"];
        std::size_t i = 0;
        for (const auto& id : ids.items())
            attributes[id.key()] = base::within(base::printable(id.key()), [&] {
                return addAttribute(attributes, id.key(), std::move(mesh.attributes[i++]), mesh.vertexCount);
            });
        return {{"attributes", attributes}, {"indices", addIndices(mesh.indices)}, {"mode", Mode::Triangles}};
    }

    static std::uint32_t attributeId(const std::string& name, const Json& id) {
        if (!id.is_number_unsigned() || id > std::numeric_limits<std::uint32_t>::max())
            base::refuse(
                fmt::format("{}: expected the id of an attribute, found {}", base::printable(name), found(id)));
        return id.get<std::uint32_t>();
    }

    // Adds an accessor that differs from the old one in its data only.
    std::size_t addAttribute(const Json& attributes, const std::string& name, DracoMesh::Attribute attribute,
                             std::uint64_t vertexCount) {
        Json accessor = entry(document_, "accessors", number(attributes, name.c_str()));
        const std::string type = text(accessor, "type", "");
        const auto component = static_cast<int>(attribute.component);
        const bool vectorFits =
            attribute.components == 1 ? type == "SCALAR" : type == fmt::format("VEC{}", attribute.components);
        if (!vectorFits || number(accessor, "componentType") != static_cast<std::uint64_t>(component))
            base::refuse(fmt::format("expected {} of componentType {} as the accessor says, found {} components of {}",
                                     base::printable(type), number(accessor, "componentType"), attribute.components,
                                     component));
        if (const std::uint64_t count = number(accessor, "count"); count != vertexCount)
            base::refuse(fmt::format("expected {} vertices as the accessor says, found {}", count, vertexCount));
        accessor["bufferView"] = addView(std::move(attribute.bytes));
        accessor.erase("byteOffset");
        return add("accessors", std::move(accessor));
    }

    std::size_t addIndices(const std::vector<std::uint32_t>& indices) {
        const auto* const start = reinterpret_cast<const std::uint8_t*>(indices.data());
        return add("accessors", {{"bufferView", addView({start, start + indices.size() * sizeof(std::uint32_t)})},
                                 {"componentType", Component::Uint32},
                                 {"count", indices.size()},
                                 {"type", scalar.name}});
    }

    // Checks a primitive that may be read without the extension: its accessors must have data of their own.
    void checkPlainData(const Json& primitive) const {
        const Json& position = member(member(primitive, "attributes"), "POSITION");
        if (position.is_null()) return;
        if (entry(document_, "accessors", number(primitive["attributes"], "POSITION")).contains("bufferView")) return;
        base::refuse(fmt::format("the geometry is compressed with {}, {}", draco, whyUnread(draco)));
    }

    // ---- buffers

    // A bufferView without a buffer is refused by the reader, if anything uses it.
    bool liesInFallback(const Json& view) const {
        const Json& index = member(view, "buffer");
        const Json& buffers = member(document_, "buffers");
        return index.is_number_unsigned() && index < sizeOf(buffers) && isFallback(buffers[index.get<std::size_t>()]);
    }

    // The bytes of a bufferView, or of an extension with the members of one.
    std::span<const std::uint8_t> bytesOf(const Json& view) const {
        const std::uint64_t buffer = number(view, "buffer");
        if (isFallback(entry(document_, "buffers", buffer)))
            base::refuse("expected data, found a buffer that stands in for some");
        return slice(buffers_.at(buffer), number(view, "byteOffset", 0), number(view, "byteLength"));
    }

    std::span<const std::uint8_t> bytesOfView(std::uint64_t view) const {
        const Json& source = entry(document_, "bufferViews", view);
        return base::within(base::label("bufferView", view), [&] { return bytesOf(source); });
    }

    std::size_t addBuffer(Bytes bytes) {
        const std::size_t index = buffers_.size();
        document_["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", std::to_string(index)}});
        buffers_.push_back(std::move(bytes));
        return index;
    }

    std::size_t addView(Bytes bytes) {
        if (bytes.empty()) base::refuse("expected at least one vertex and one triangle, found none");
        bytesLeft_ -= bytes.size();
        const std::size_t size = bytes.size();
        return add("bufferViews", {{"buffer", addBuffer(std::move(bytes))}, {"byteLength", size}});
    }

    std::size_t add(const char* list, Json item) {
        document_[list].push_back(std::move(item));
        return document_[list].size() - 1;
    }

    Json& document_;
    std::vector<Bytes>& buffers_;
    std::uint64_t bytesLeft_;
    std::map<Json, Json> plain_;
};

}  // namespace

bool isCompression(std::string_view extension) noexcept {
    return extension == draco || std::ranges::count(meshopts, extension) == 1;
}

bool readsCompression(std::string_view extension) {
    return isCompression(extension) && modules::failureToOpen(moduleOf(extension)).empty();
}

std::string whyUnread(std::string_view extension) {
    return fmt::format("which this build does not read: {}", modules::failureToOpen(moduleOf(extension)));
}

void markFallbacks(Json& document, bool hasBinaryChunk) {
    const std::size_t views = sizeOf(member(document, "bufferViews"));
    for (std::size_t i = 0; i < views; ++i) {
        const Json& view = document["bufferViews"][i];
        const Json& index = member(view, "buffer");
        if (meshoptOf(view) == nullptr || !index.is_number_unsigned()) continue;
        if (index >= sizeOf(member(document, "buffers")) || (index == 0 && hasBinaryChunk)) continue;
        Json& buffer = document["buffers"][index.get<std::size_t>()];
        if (buffer.is_object() && !buffer.contains("uri"))
            buffer["extensions"] = {{meshopts.front(), {{"fallback", true}}}};
    }
}

bool isFallback(const Json& buffer) {
    const char* const name = meshoptOf(buffer);
    return name != nullptr && member(extension(buffer, name), "fallback") == true &&
           (readsMeshopt() || !buffer.contains("uri"));
}

void decompress(Json& document, std::vector<Bytes>& buffers, std::uint64_t maxBytes) {
    Decompression{document, buffers, maxBytes}.run();
}

}  // namespace inkedge::gltf
