#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "formats/gltf/file.h"
#include "formats/gltf/mask_levels.h"
#include "formats/gltf/model.h"
#include "formats/gltf/shape.h"
#include "mesh/cut_out.h"

namespace inkedge::gltf {

/// The cut-outs of a file's materials with a mask, each made when it is first used. The constructor's arguments must
/// outlive this.
class CutOuts {
public:
    CutOuts(const tinygltf::Model& model, const File& file, const formats::ModelInput& input, const LoadLimits& limits)
        : model_{model}, file_{file}, input_{input}, maxPixels_{limits.imagePixels}, bytesLeft_{file.bytesLeft} {}

    /// Halves the masks that are too fine to be cut along in time. To be called before apply().
    /// @return  a warning, if there is one; or empty
    [[nodiscard]] std::string coarsen(const std::vector<MaskUse>&);

    /// Keeps only the opaque parts of a primitive's triangles.
    /// @throws Error  (Kind::Input) if the mask's picture cannot be read
    void apply(const Material&, const tinygltf::Primitive&, Shape& part);

    /// The opaque parts of straight pieces of lines, two positions each. Only the opacities of the material and the
    /// vertices count: pictures are for surfaces.
    /// @param ends  into positions, two a piece
    [[nodiscard]] std::vector<glm::dvec3> opaqueLines(const Material&, const tinygltf::Primitive&,
                                                      const std::vector<glm::dvec3>& positions,
                                                      const std::vector<std::uint32_t>& ends) const;

private:
    // Where an opacity of the vertices changes within a triangle.
    [[nodiscard]] std::vector<mesh::TrianglePiece> cutVarying(const Material&, const std::vector<glm::dvec2>& uvs,
                                                              const glm::dvec3& opacities,
                                                              const std::uint32_t* corners);
    [[nodiscard]] std::vector<mesh::TrianglePiece> cutEven(const Material&, const std::vector<glm::dvec2>& uvs,
                                                           double opacity, const std::uint32_t* corners);
    mesh::CutOut* find(const Texture&, double threshold);
    const Mask& opacityMap(std::uint64_t number, const Image& image);

    const tinygltf::Model& model_;
    const File& file_;
    const formats::ModelInput& input_;
    std::uint64_t maxPixels_;
    std::uint64_t bytesLeft_;
    std::uint64_t cellsLeft_ = mesh::CutOut::maxCells;
    std::map<std::uint64_t, Mask> maps_;
    std::map<std::tuple<std::uint64_t, Wrap, Wrap, double>, std::unique_ptr<mesh::CutOut>> cutOuts_;
};

}  // namespace inkedge::gltf
