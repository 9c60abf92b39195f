#include "formats/gltf/draco.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <inkedge/export.h>

#include "base/message.h"

namespace inkedge::gltf {

namespace {

// Draco allocates about 100 bytes per triangle as soon as it has read the number of triangles.
constexpr std::uint32_t maximumTriangles = std::uint32_t{1} << 24;

draco::DecoderBuffer bufferOver(std::span<const std::uint8_t> data) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
    return buffer;
}

draco::DracoHeader readHeader(draco::DecoderBuffer& buffer) {
    draco::DracoHeader header{};
    if (const draco::Status status = draco::PointCloudDecoder::DecodeHeader(&buffer, &header); !status.ok())
        base::refuse("expected Draco data, found: " + base::printable(status.error_msg_string()));
    if (header.version_major != draco::kDracoMeshBitstreamVersionMajor ||
        header.version_minor != draco::kDracoMeshBitstreamVersionMinor)
        base::refuse(
            fmt::format("expected Draco bitstream 2.2, found {}.{}", header.version_major, header.version_minor));
    if (header.encoder_type != draco::TRIANGULAR_MESH)
        base::refuse(fmt::format("expected a Draco mesh, found geometry of type {}", header.encoder_type));
    return header;
}

// The number of triangles that the data say before anything is decoded; Draco bitstream specification 2.2, sections 3
// to 5.
std::uint32_t encodedTriangles(std::span<const std::uint8_t> data) {
    draco::DecoderBuffer buffer = bufferOver(data);
    const draco::DracoHeader header = readHeader(buffer);
    buffer.set_bitstream_version(draco::kDracoMeshBitstreamVersion);
    if ((header.flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata ignored;
        if (!draco::MetadataDecoder{}.DecodeGeometryMetadata(&buffer, &ignored))
            base::refuse("expected Draco metadata, found damaged data");
    }
    std::uint8_t traversal = 0;
    std::uint32_t vertices = 0;
    std::uint32_t triangles = 0;
    bool read = true;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
        read = buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer);
    if (!read || !draco::DecodeVarint(&triangles, &buffer))
        base::refuse(fmt::format("expected Draco data, found {} bytes: they are truncated", data.size()));
    return triangles;
}

void checkTriangles(std::uint32_t found, const DracoExpected& expected) {
    if (expected.triangleCount && found != *expected.triangleCount)
        base::refuse(fmt::format("expected {} triangles as the accessor of the indices says, found {}",
                                 *expected.triangleCount, found));
    if (found > maximumTriangles)
        base::refuse(fmt::format("expected at most {} triangles in a Draco mesh, found {}", maximumTriangles, found));
}

Component componentOf(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return Component::Int8;
        case draco::DT_UINT8:
            return Component::Uint8;
        case draco::DT_INT16:
            return Component::Int16;
        case draco::DT_UINT16:
            return Component::Uint16;
        case draco::DT_UINT32:
            return Component::Uint32;
        case draco::DT_FLOAT32:
            return Component::Float;
        default:
            base::refuse(
                fmt::format("expected a component type of glTF, found Draco's type {}", static_cast<int>(type)));
    }
}

void spend(std::uint64_t bytes, std::uint64_t& bytesLeft) {
    if (bytes > bytesLeft)
        base::refuse(
            fmt::format("expected at most {} bytes more in decompressed data, found {}; raise max-decompressed-size",
                        bytesLeft, bytes));
    bytesLeft -= bytes;
}

DracoMesh::Attribute readAttribute(const draco::Mesh& mesh, std::uint32_t id, std::uint64_t& bytesLeft) {
    const draco::PointAttribute* const source = mesh.GetAttributeByUniqueId(id);
    if (source == nullptr) base::refuse("expected an attribute of that id in the Draco mesh, found none");
    const Component component = componentOf(source->data_type());
    const auto size = static_cast<std::size_t>(source->num_components() * draco::DataTypeLength(source->data_type()));
    const auto stride = static_cast<std::size_t>(source->byte_stride());
    const auto stored = static_cast<std::size_t>(source->buffer()->data_size());
    spend(size * mesh.num_points(), bytesLeft);

    DracoMesh::Attribute attribute{static_cast<std::uint64_t>(source->num_components()), component, {}};
    attribute.bytes.resize(size * mesh.num_points());
    for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
        const std::size_t value = source->mapped_index(draco::PointIndex{point}).value();
        if (value >= source->size() || stored < size || value * stride > stored - size)
            base::refuse(fmt::format("expected a value for vertex {}, found none", point));
        std::memcpy(attribute.bytes.data() + point * size, source->buffer()->data() + value * stride, size);
    }
    return attribute;
}

std::vector<std::uint32_t> readTriangles(const draco::Mesh& mesh, std::uint64_t& bytesLeft) {
    spend(std::uint64_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t), bytesLeft);
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{mesh.num_faces()} * 3);
    for (std::uint32_t face = 0; face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : mesh.face(draco::FaceIndex{face})) indices.push_back(point.value());
    return indices;
}

DecodedDraco decode(std::span<const std::uint8_t> data, const DracoExpected& expected, std::uint64_t bytesLeft) {
    checkTriangles(encodedTriangles(data), expected);
    draco::DecoderBuffer buffer = bufferOver(data);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
        base::refuse("expected Draco data, found: " + base::printable(decoded.status().error_msg_string()));
    const std::unique_ptr<draco::Mesh> source = std::move(decoded).value();
    checkTriangles(source->num_faces(), expected);

    DracoMesh mesh{source->num_points(), readTriangles(*source, bytesLeft), {}};
    for (const std::uint32_t id : expected.attributes)
        mesh.attributes.push_back(
            base::within(base::label("attribute", id), [&] { return readAttribute(*source, id, bytesLeft); }));
    return {std::move(mesh), {}};
}

}  // namespace

extern "C" INKEDGE_API const DracoFunctions* inkedge_draco_1() noexcept {
    static constexpr DracoFunctions functions{
        [](std::span<const std::uint8_t> data, const DracoExpected& expected, std::uint64_t bytesLeft) {
            return modules::guarded([&] { return decode(data, expected, bytesLeft); });
        }};
    return &functions;
}

}  // namespace inkedge::gltf
