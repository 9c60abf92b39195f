#pragma once

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <string>
#include <vector>

#include "formats/cad/model.h"
#include "formats/cad/occt_healing.h"
#include "formats/cad/request.h"

namespace inkedge::cad {

enum class CadFormat { Step, Iges, Brep };

/// A shape of the file that instances show, and what the file says of its faces.
struct DocumentPart {
    std::string name;
    TopoDS_Shape shape;
    std::uint32_t material = 0;                 ///< of faces that have none of their own: 1 + its number; 0: none
    std::vector<std::uint32_t> materials = {};  ///< one per face, in the order of TopExp::MapShapes
    std::vector<bool> invisible = {};           ///< one per face
    double scale = 1.0;                         ///< of the shape: 1 / scale of its lengths is a millimetre
};

/// A CAD file, read.
struct Document {
    std::vector<DocumentPart> parts;
    Model model;                   ///< all but its parts
    std::uint64_t curves = 0;      ///< that are no edges of faces
    std::uint64_t points = 0;      ///< that are no ends of curves
    std::uint64_t invisible = 0;   ///< items that the file hides
    std::uint64_t unreadable = 0;  ///< items that OpenCASCADE could not make shapes of
    bool mendedLess = false;       ///< than in full
};

/// Reads a file whose first and last lines are right, within the limits of instances and nodes.
/// @throws std::runtime_error  with what was expected and what was found instead; Standard_Failure as OpenCASCADE
[[nodiscard]] Document readDocument(const char* file, CadFormat, Healing, const Request&);

}  // namespace inkedge::cad
