#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <inkedge/image.h>

namespace inkedge::gltf {

/// The opacity of a picture, one channel; null: it has none, or cannot be read.
using Mask = std::shared_ptr<const inkedge::Image<std::uint8_t>>;

/// What a mask is to be cut from.
struct MaskUse {
    std::uint64_t image = 0;  ///< the number of the mask's picture
    double threshold = 0.0;   ///< 0 to 255
    double area = 0.0;        ///< of the triangles, in uv: 1 is the whole picture
    double edges = 0.0;       ///< the lengths of their edges, in uv
    double triangles = 0.0;
    bool varies = false;  ///< whether the vertices' opacity changes within triangles
};

/// Halves masks, the most laborious first, until cutting along all of them is work of a second or two.
/// @param masks  by the number of their picture
/// @return       those that were halved
[[nodiscard]] std::map<std::uint64_t, Mask> coarserMasks(const std::vector<MaskUse>&,
                                                         std::map<std::uint64_t, Mask> masks);

}  // namespace inkedge::gltf
