#include "formats/gltf/file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/read_file.h"
#include "formats/gltf/compression.h"
#include "formats/gltf/json.h"
#include "formats/gltf/named_files.h"
#include "formats/gltf/uri.h"

namespace inkedge::gltf {

namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr int maximumDepth = 500;

// Where the chunks of a .glb lie.
struct Chunks {
    std::string_view json;
    std::span<const std::uint8_t> binary;
};

std::uint32_t littleEndianAt(std::span<const std::uint8_t> bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

Chunks splitGlb(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t headerSize = 12;
    constexpr std::size_t chunkHeaderSize = 8;
    constexpr std::uint32_t jsonChunk = 0x4e4f534a;
    constexpr std::uint32_t binaryChunk = 0x004e4942;
    if (bytes.size() < headerSize + chunkHeaderSize)
        base::refuse(
            fmt::format("expected a .glb of at least 20 bytes, found {}: the file is truncated", bytes.size()));
    if (const std::uint32_t version = littleEndianAt(bytes, 4); version != 2)
        base::refuse(fmt::format("expected version 2 of binary glTF, found version {}", version));
    const std::uint32_t length = littleEndianAt(bytes, 8);
    if (length > bytes.size())
        base::refuse(
            fmt::format("expected {} bytes as the header says, found {}: the file is truncated", length, bytes.size()));
    bytes = bytes.first(length);

    Chunks chunks;
    std::size_t at = headerSize;
    for (int chunk = 0; chunk < 2 && at + chunkHeaderSize <= bytes.size(); ++chunk) {
        const std::uint32_t size = littleEndianAt(bytes, at);
        const std::uint32_t type = littleEndianAt(bytes, at + 4);
        at += chunkHeaderSize;
        if (size > bytes.size() - at)
            base::refuse(fmt::format("expected {} bytes in chunk {}, found {}", size, chunk, bytes.size() - at));
        if (chunk == 0 && type != jsonChunk)
            base::refuse(fmt::format("expected a JSON chunk first, found type 0x{:08x}", type));
        if (chunk == 0) chunks.json = base::textOf(bytes.subspan(at, size));
        if (chunk == 1 && type == binaryChunk) chunks.binary = bytes.subspan(at, size);
        at += size;
    }
    while (chunks.json.ends_with('\0')) chunks.json.remove_suffix(1);  // some writers pad with zeros, not spaces
    return chunks;
}

// tinygltf takes 12.0 for a missing value where an integer is expected, and cuts integers to 32 bits.
void normalizeNumber(Json& value) {
    constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number < 0 || number > static_cast<double>(largest) || number != std::floor(number)) return;
        value = static_cast<std::uint64_t>(number);
    } else if (value.is_number_unsigned()) {
        value = std::min(value.get<std::uint64_t>(), static_cast<std::uint64_t>(largest));
    } else if (value.is_number_integer()) {
        value = std::max(value.get<std::int64_t>(), -largest);
    }
}

// Checks the depth before parsing, since a nested value takes many times the memory of its text.
void checkDepth(std::string_view text) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') inString = !inString;
        if (inString) {
            if (c == '\\') ++i;
        } else if (c == '{' || c == '[') {
            if (++depth > maximumDepth)
                base::refuse(fmt::format("expected JSON nested at most {} deep, found deeper", maximumDepth));
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

// Recursion is safe: checkDepth() has bounded it.
void simplify(Json& value) {
    if (value.is_object()) value.erase("extras");
    if (value.is_structured())
        for (Json& member : value) simplify(member);
    else
        normalizeNumber(value);
}

Json parseJson(std::string_view text) {
    checkDepth(text);
    Json document;
    try {
        document = Json::parse(text.begin(), text.end());
    } catch (const Json::exception& error) {
        const std::string_view message = error.what();  // "[json.exception.parse_error.101] parse error at ..."
        const std::size_t end = message.find("] ");
        base::refuse("expected JSON, found " +
                     base::printable(message.substr(end == std::string_view::npos ? 0 : end + 2).substr(0, 300)));
    }
    if (!document.is_object()) base::refuse(fmt::format("expected a JSON object, found {}", document.type_name()));
    document.erase("extensions");
    simplify(document);
    return document;
}

// The string member of an object, or nothing.
std::string stringIn(const Json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_string()) return {};
    return object[key].get<std::string>();
}

void checkVersion(const Json& document) {
    const Json asset = document.value("asset", Json::object());
    const std::string version = stringIn(asset, "version");
    const std::string minimum = stringIn(asset, "minVersion");
    if (version.empty()) base::refuse("expected glTF 2.0, found JSON without asset.version");
    if (!version.starts_with("2.")) base::refuse("expected glTF 2.0, found version " + base::quote(version));
    if (!minimum.empty() && minimum != "2.0")
        base::refuse("expected glTF 2.0, found minVersion " + base::quote(minimum));
}

// tinygltf ignores an optional number that is below 0 or no number: such a number is refused here.
void checkExtents(const Json& object) {
    if (!object.is_object()) return;
    for (const char* name : {"byteOffset", "byteLength", "byteStride", "count"}) {
        const auto found = object.find(name);
        if (found != object.end() && !found->is_number_unsigned())
            base::refuse(fmt::format("{}: expected a number of at least 0, found {}", name,
                                     base::printable(found->dump().substr(0, 80))));
    }
    for (const char* part : {"sparse", "indices", "values"})
        if (const auto found = object.find(part); found != object.end())
            base::within(part, [&] { checkExtents(*found); });
}

void checkExtents(const Json& document, const char* list, const char* kind) {
    const auto found = document.find(list);
    if (found == document.end() || !found->is_array()) return;
    for (std::size_t i = 0; i < found->size(); ++i)
        base::within(base::label(kind, i), [&] { checkExtents((*found)[i]); });
}

// Whether an extension is about what a drawing of lines never shows: light, sound, physics, behaviour, metadata, and
// coarser models for the distance.
bool isBesideTheDrawing(std::string_view extension) {
    constexpr std::array subjects{
        "lights_"sv,         "environment"sv,   "materials_"sv,
        "audio"sv,           "physics_"sv,      "rigid_body"sv,
        "collider"sv,        "collision_"sv,    "vehicle_"sv,
        "articulations"sv,   "interactivity"sv, "xmp"sv,
        "mesh_manifold"sv,   "lod"sv,           "structural_metadata"sv,
        "mesh_features"sv,   "metadata"sv,      "geometry_metadata"sv,
        "implicit_shapes"sv, "single_root"sv,   "springBone"sv,
        "packing_"sv,        "seat"sv,          "instance_features"sv,
        "spawn_point"sv,     "link"sv,          "feature_metadata"sv,
    };
    const std::size_t vendorEnd = extension.find('_');
    if (vendorEnd == std::string_view::npos) return false;
    const std::string_view subject = extension.substr(vendorEnd + 1);
    return std::ranges::any_of(subjects, [&](std::string_view known) { return subject.starts_with(known); });
}

// glTF allows channels whose target has no node, tinygltf does not: it gets a node that is none.
void completeTargets(Json& document) {
    const auto animations = document.find("animations");
    if (animations == document.end() || !animations->is_array()) return;
    for (Json& animation : *animations) {
        if (!animation.is_object() || !member(animation, "channels").is_array()) continue;
        for (Json& channel : animation["channels"])
            if (member(channel, "target").is_object()) channel["target"].emplace("node", -1);
    }
}

// Whether an extension is about pictures: KHR_texture_transform, and those that give them in another form. A mask or
// paint that needs a form that is not read gets a warning.
bool concernsPictures(std::string_view extension) {
    const std::size_t end = extension.find('_');
    return end != std::string_view::npos &&
           (extension.substr(end).starts_with("_texture_") || extension.substr(end).starts_with("_image_"));
}

// Whether an extension is read, or does not change the shape.
bool isRead(std::string_view extension) {
    constexpr std::array names{
        "KHR_mesh_quantization"sv,
        "EXT_mesh_gpu_instancing"sv,
        "KHR_animation_pointer"sv,
        "KHR_node_visibility"sv,
        "KHR_node_hoverability"sv,
        "KHR_node_selectability"sv,
        "EXT_mesh_primitive_edge_visibility"sv,
        "CESIUM_primitive_outline"sv,
        "KHR_mesh_primitive_restart"sv,
        "EXT_mesh_primitive_restart"sv,
    };
    return readsCompression(extension) || std::ranges::find(names, extension) != names.end() ||
           concernsPictures(extension) || isBesideTheDrawing(extension);
}

std::vector<std::string> extensionsIn(const Json& document, const char* list) {
    const Json extensions = document.value(list, Json::array());
    if (!extensions.is_array())
        base::refuse(fmt::format("{}: expected an array, found {}", list, extensions.type_name()));
    std::vector<std::string> names;
    for (const Json& entry : extensions) {
        if (!entry.is_string()) base::refuse(fmt::format("{}: expected names, found {}", list, entry.type_name()));
        names.push_back(entry.get<std::string>());
    }
    return names;
}

bool allowsRestarts(const Json& document) {
    const auto isRestart = [](std::string_view name) { return name.ends_with("_mesh_primitive_restart"); };
    return std::ranges::any_of(extensionsIn(document, "extensionsUsed"), isRestart) ||
           std::ranges::any_of(extensionsIn(document, "extensionsRequired"), isRestart);
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + base::printable(std::string_view{name}.substr(0, 80));
    return list;
}

void checkRequiredExtensions(const Json& document) {
    std::vector<std::string> unread = extensionsIn(document, "extensionsRequired");
    std::erase_if(unread, isRead);
    if (unread.empty()) return;
    if (std::ranges::all_of(unread, isCompression))
        base::refuse(fmt::format("the geometry is compressed with {}, {}", listed(unread), whyUnread(unread.front())));
    base::refuse("expected only required extensions that this version reads, found " + listed(unread));
}

std::vector<std::string> warningsOf(std::vector<std::string> used) {
    std::erase_if(used, [](const std::string& name) { return isRead(name) || isCompression(name); });
    if (used.empty()) return {};
    return {fmt::format("uses {} that this version does not read: {}", used.size() == 1 ? "an extension" : "extensions",
                        listed(used))};
}

base::Bytes bufferBytes(const formats::ModelInput& input, const Json& buffer, std::optional<base::Bytes> binaryChunk,
                        std::uint64_t& bytesLeft) {
    if (buffer.contains("uri")) {
        if (!buffer["uri"].is_string())
            base::refuse(fmt::format("expected a string as uri, found {}", buffer["uri"].type_name()));
        return readUri(input, buffer["uri"].get_ref<const std::string&>(), bytesLeft);
    }
    if (!binaryChunk) base::refuse("expected a uri or the binary chunk of a .glb, found neither");
    return std::move(*binaryChunk);
}

// One byte for a buffer that nothing reads, as no buffer may be empty.
base::Bytes standIn(Json& buffer, std::size_t number) {
    constexpr std::string_view extension = "KHR_meshopt_compression";
    if (!readsCompression(extension))
        base::refuse("it stands in for data compressed with meshopt, " + whyUnread(extension));
    buffer["uri"] = std::to_string(number);
    buffer["byteLength"] = 1;
    return {0};
}

// Takes the bytes of the buffers, and replaces their URIs by numbers.
std::vector<base::Bytes> takeBuffers(const formats::ModelInput& input, Json& document,
                                     std::optional<base::Bytes> binaryChunk, std::uint64_t& bytesLeft) {
    std::vector<base::Bytes> buffers;
    if (!document.contains("buffers")) return buffers;
    Json& list = document["buffers"];
    if (!list.is_array()) base::refuse(fmt::format("buffers: expected an array, found {}", list.type_name()));
    for (Json& buffer : list) {
        const std::size_t number = buffers.size();
        base::within(base::label("buffer", number), [&] {
            if (!buffer.is_object()) base::refuse(fmt::format("expected an object, found {}", buffer.type_name()));
            const Json length = buffer.value("byteLength", Json{});
            if (!length.is_number_unsigned() || length == 0)
                base::refuse("expected a byteLength over 0, found " + base::printable(length.dump().substr(0, 80)));
            if (isFallback(buffer)) return buffers.push_back(standIn(buffer, number));
            base::Bytes bytes =
                bufferBytes(input, buffer, number == 0 ? std::move(binaryChunk) : std::nullopt, bytesLeft);
            if (bytes.size() < length.get<std::uint64_t>())
                base::refuse(fmt::format("expected {} bytes, found {}", length.get<std::uint64_t>(), bytes.size()));
            bytes.resize(length.get<std::uint64_t>());
            buffer["uri"] = std::to_string(number);
            buffers.push_back(std::move(bytes));
        });
    }
    return buffers;
}

// The accessors of indices without a bufferView.
std::set<std::size_t> bareIndices(const Json& document) {
    const Json& accessors = member(document, "accessors");
    std::set<std::size_t> bare;
    for (const Json& mesh : member(document, "meshes"))
        for (const Json& primitive : member(mesh, "primitives")) {
            const Json& index = member(primitive, "indices");
            if (!index.is_number_unsigned() || index >= sizeOf(accessors)) continue;
            const Json& accessor = accessors[index.get<std::size_t>()];
            if (accessor.is_object() && !accessor.contains("bufferView")) bare.insert(index.get<std::size_t>());
        }
    return bare;
}

// Gives indices without a bufferView, which are zeros before sparse ones are put in, a bufferView of zeros: tinygltf
// refuses them otherwise.
void fillIndices(Json& document, std::vector<base::Bytes>& buffers) {
    std::uint64_t limit = std::uint64_t{1} << 16U;  // a small file must not take much memory
    for (const base::Bytes& buffer : buffers) limit = std::max<std::uint64_t>(limit, buffer.size());
    std::uint64_t size = 0;
    for (const std::size_t index : bareIndices(document)) {
        Json& accessor = document["accessors"][index];
        const std::uint64_t count =
            base::within(base::label("accessor", index), [&] { return number(accessor, "count"); });
        if (count > limit)
            base::refuse(fmt::format("{}: expected at most {} elements without data, found {}",
                                     base::label("accessor", index), limit, count));
        accessor["bufferView"] = sizeOf(member(document, "bufferViews"));
        accessor.erase("byteOffset");
        size = std::max(size, count * sizeof(std::uint32_t));
    }
    if (size == 0) return;
    document["bufferViews"].push_back({{"buffer", buffers.size()}, {"byteLength", size}});
    document["buffers"].push_back({{"byteLength", size}, {"uri", std::to_string(buffers.size())}});
    buffers.emplace_back(size);
}

bool looksLikeJson(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && text[start] == '{';
}

}  // namespace

base::Bytes readUri(const formats::ModelInput& input, const std::string& uri, std::uint64_t& bytesLeft) {
    if (isDataUri(uri)) return decodeDataUri(uri);
    if (!input.isFile())
        base::refuse("expected all data within a model in memory, embedded or as data URIs, found the file " +
                     base::quote(uri));
    const fs::path file = fileOfUri(input.name, uri);
    return base::within(base::quote(uri), [&] { return base::readBytes(file, bytesLeft); });
}

File readFile(const formats::ModelInput& input, const LoadLimits& limits) {
    File file;
    file.bytesLeft = limits.fileSize;
    formats::Content bytes{input, file.bytesLeft};
    const std::string_view content = base::textOf(bytes.bytes());
    const bool binary = content.starts_with("glTF");
    if (!binary && !looksLikeJson(content))
        base::refuse(fmt::format("expected glTF 2.0 (.glb or .gltf), found {}", base::kindOf(content)));

    const Chunks chunks = binary ? splitGlb(bytes.bytes()) : Chunks{content, {}};
    Json document = parseJson(chunks.json);
    checkVersion(document);
    checkRequiredExtensions(document);
    completeTargets(document);
    checkExtents(document, "accessors", "accessor");
    checkExtents(document, "bufferViews", "bufferView");
    file.extensions = extensionsIn(document, "extensionsUsed");
    file.primitiveRestart = allowsRestarts(document);
    file.warnings = warningsOf(file.extensions);
    file.materials = readMaterials(document);
    file.images = readImages(document);
    file.named = namedFiles(input, document);
    for (const char* read : {"images", "materials", "samplers", "textures"}) document.erase(read);
    std::optional<base::Bytes> binaryChunk;
    if (!chunks.binary.empty()) binaryChunk = std::move(bytes).keepOnly(chunks.binary);
    markFallbacks(document, binaryChunk.has_value());
    file.buffers = takeBuffers(input, document, std::move(binaryChunk), file.bytesLeft);
    decompress(document, file.buffers, limits.decompressedSize);
    fillIndices(document, file.buffers);
    file.json = document.dump();
    return file;
}

}  // namespace inkedge::gltf
