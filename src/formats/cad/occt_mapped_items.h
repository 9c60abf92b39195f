#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

class STEPControl_Reader;

namespace inkedge::cad {

/// A shape where a MAPPED_ITEM of a STEP file mirrors or scales it, which OpenCASCADE 7.6 leaves out.
struct MappedShape {
    TopoDS_Shape shape;  ///< as OpenCASCADE puts it into its assembly
    glm::dmat4 transform{1.0};
    std::string name;
    bool taken = false;
};

/// Those of a file whose shapes are transferred.
[[nodiscard]] std::vector<MappedShape> mappedShapes(const STEPControl_Reader&);

}  // namespace inkedge::cad
