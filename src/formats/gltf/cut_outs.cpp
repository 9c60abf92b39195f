#include "formats/gltf/cut_outs.h"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/message.h"
#include "formats/gltf/mask_uses.h"
#include "formats/gltf/paint.h"
#include "images/decode_picture.h"

namespace inkedge::gltf {

namespace {

// Edges of a piece that lie on an edge of the triangle have its kinds.
void addEdges(const std::vector<EdgeKinds>& of, std::size_t triangle, const mesh::TrianglePiece& piece,
              std::vector<EdgeKinds>& rest) {
    constexpr double nothing = 1e-9;  // what rounding leaves of a weight
    if (of.empty()) return;
    for (std::size_t k = 0; k < 3; ++k) {
        EdgeKinds said;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const auto opposite = static_cast<int>((edge + 2) % 3);
            const bool liesOnIt = piece[k][opposite] <= nothing && piece[(k + 1) % 3][opposite] <= nothing;
            if (liesOnIt) said |= of[3 * triangle + edge];
        }
        rest.push_back(said);
    }
}

void add(const Shape& part, std::size_t triangle, const mesh::TrianglePiece& piece, Shape& rest) {
    const std::uint32_t* const corners = &part.indices[3 * triangle];
    const auto mixed = [&](const std::vector<glm::dvec3>& of, const glm::dvec3& weights) {
        return weights.x * of[corners[0]] + weights.y * of[corners[1]] + weights.z * of[corners[2]];
    };
    for (const glm::dvec3& weights : piece) {
        rest.indices.push_back(static_cast<std::uint32_t>(rest.positions.size()));
        rest.positions.push_back(mixed(part.positions, weights));
        rest.normals.push_back(mixed(part.normals, weights));
        if (!part.coordinates.empty()) {
            const glm::vec3 w{weights};
            rest.coordinates.push_back(w.x * part.coordinates[corners[0]] + w.y * part.coordinates[corners[1]] +
                                       w.z * part.coordinates[corners[2]]);
        }
    }
    for (const glm::dvec3& weights : piece) {
        if (part.paint.empty()) break;
        const glm::vec3 w{weights};
        const VertexPaint* const at[]{&part.paint[corners[0]], &part.paint[corners[1]], &part.paint[corners[2]]};
        rest.paint.push_back({w.x * at[0]->color + w.y * at[1]->color + w.z * at[2]->color,
                              w.x * at[0]->uv + w.y * at[1]->uv + w.z * at[2]->uv});
    }
    rest.materials.push_back(part.materials[triangle]);
    addEdges(part.edges, triangle, piece, rest.edges);
}

}  // namespace

void CutOuts::apply(const Material& material, const tinygltf::Primitive& primitive, Shape& part) {
    const std::vector<double> opacities = vertexOpacities(model_, primitive, part.positions.size());
    const auto opacityOf = [&](const std::uint32_t* corners) {
        return material.opacity * glm::dvec3{opacities[corners[0]], opacities[corners[1]], opacities[corners[2]]};
    };
    std::vector<glm::dvec2> uvs;
    if (material.texture) uvs = uvsOf(model_, *material.texture, primitive, part.positions.size());
    const bool changes = varies(opacities, part.indices);
    Shape rest;
    rest.authored = part.authored;
    for (std::size_t t = 0; t < part.indices.size() / 3; ++t) {
        const std::uint32_t* const corners = &part.indices[3 * t];
        const glm::dvec3 opacity = opacityOf(corners);
        for (const mesh::TrianglePiece& piece :
             changes ? cutVarying(material, uvs, opacity, corners) : cutEven(material, uvs, opacity.x, corners))
            add(part, t, piece, rest);
    }
    part = std::move(rest);
}

std::vector<glm::dvec3> CutOuts::opaqueLines(const Material& material, const tinygltf::Primitive& primitive,
                                             const std::vector<glm::dvec3>& positions,
                                             const std::vector<std::uint32_t>& ends) const {
    std::vector<double> opacities = vertexOpacities(model_, primitive, positions.size());
    opacities.resize(positions.size(), 1.0);
    std::vector<glm::dvec3> opaque;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
        std::array<glm::dvec3, 2> piece{positions[ends[i]], positions[ends[i + 1]]};
        const std::array<double, 2> over{material.opacity * opacities[ends[i]] - material.cutoff,
                                         material.opacity * opacities[ends[i + 1]] - material.cutoff};
        if (over[0] < 0.0 && over[1] < 0.0) continue;
        if (over[0] < 0.0 || over[1] < 0.0) {
            const glm::dvec3 rim = glm::mix(piece[0], piece[1], over[0] / (over[0] - over[1]));
            piece[over[0] < 0.0 ? 0 : 1] = rim;
        }
        opaque.insert(opaque.end(), piece.begin(), piece.end());
    }
    return opaque;
}

std::vector<mesh::TrianglePiece> CutOuts::cutEven(const Material& material, const std::vector<glm::dvec2>& uvs,
                                                  double opacity, const std::uint32_t* corners) {
    if (opacity < material.cutoff) return {};
    mesh::CutOut* const cutOut = uvs.empty() ? nullptr : find(*material.texture, material.cutoff / opacity);
    if (cutOut == nullptr) return {mesh::TrianglePiece{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}}};
    return cutOut->cut({uvs[corners[0]], uvs[corners[1]], uvs[corners[2]]});
}

std::vector<mesh::TrianglePiece> CutOuts::cutVarying(const Material& material, const std::vector<glm::dvec2>& uvs,
                                                     const glm::dvec3& opacities, const std::uint32_t* corners) {
    if (glm::all(glm::lessThan(opacities, glm::dvec3{material.cutoff}))) return {};
    mesh::CutOut* const cutOut = uvs.empty() ? nullptr : find(*material.texture, material.cutoff);
    if (cutOut != nullptr) return cutOut->cut({uvs[corners[0]], uvs[corners[1]], uvs[corners[2]]}, opacities);
    return mesh::opaquePart({1, 1, 1}, [&](const glm::dvec3& w) { return glm::dot(w, opacities) - material.cutoff; });
}

std::string CutOuts::coarsen(const std::vector<MaskUse>& uses) {
    std::map<std::uint64_t, Mask> masks;
    for (const MaskUse& use : uses) {
        if (masks.contains(use.image)) continue;
        try {
            masks[use.image] = opacityMap(use.image, file_.images[use.image]);
        } catch (const Error&) {  // whoever cuts along it says so
        }
    }
    std::string warning;
    const std::map<std::uint64_t, Mask> coarser = coarserMasks(uses, masks);
    for (const auto& [image, mask] : coarser) {
        const Size before = masks[image]->size();
        maps_[image] = mask;
        if (warning.empty())
            warning = fmt::format(
                "cut-outs leave out what is finer than can be cut in time: image {} of {} x {} texels "
                "is cut at {} x {}",
                image, before.width, before.height, mask->size().width, mask->size().height);
    }
    if (coarser.size() > 1) warning += fmt::format(", and {} more likewise", coarser.size() - 1);
    return warning;
}

// Null if the picture has no alpha or the threshold is 0.
mesh::CutOut* CutOuts::find(const Texture& texture, double threshold) {
    constexpr double opaque = 255.0;
    const Image& image = imageOf(file_, texture);
    if (!(threshold > 0.0)) return nullptr;
    const Mask& mask = opacityMap(*texture.image, image);
    if (!mask) return nullptr;
    auto& cutOut = cutOuts_[{*texture.image, texture.wrapS, texture.wrapT, threshold}];
    if (!cutOut)
        cutOut = std::make_unique<mesh::CutOut>(mask, std::array{wrapOf(texture.wrapS), wrapOf(texture.wrapT)},
                                                opaque * threshold, cellsLeft_);
    return cutOut.get();
}

const Mask& CutOuts::opacityMap(std::uint64_t number, const Image& image) {
    const auto known = maps_.find(number);
    if (known != maps_.end()) return known->second;
    return base::within(base::label("image", number), [&]() -> const Mask& {
        const base::Bytes bytes = pictureBytes(model_, input_, image, bytesLeft_);
        std::optional<inkedge::Image<std::uint8_t>> opacity = images::decodeOpacity(bytes, maxPixels_);
        Mask& mask = maps_[number];
        if (opacity) mask = std::make_shared<const inkedge::Image<std::uint8_t>>(std::move(*opacity));
        return mask;
    });
}

}  // namespace inkedge::gltf
