#include "formats/gltf/line_pieces.h"

#include <cstddef>

namespace inkedge::gltf {

std::vector<std::uint32_t> linePieces(Mode mode, std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> pieces;
    const std::size_t step = mode == Mode::Lines ? 2 : 1;
    for (const std::span<const std::uint32_t> run : runsOf(corners)) {
        for (std::size_t i = 1; i < run.size(); i += step) pieces.insert(pieces.end(), {run[i - 1], run[i]});
        if (mode == Mode::LineLoop && run.size() > 2) pieces.insert(pieces.end(), {run.back(), run.front()});
    }
    return pieces;
}

}  // namespace inkedge::gltf
