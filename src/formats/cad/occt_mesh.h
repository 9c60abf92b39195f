#pragma once

#include <cstdint>

#include "formats/cad/occt_document.h"

namespace inkedge::cad {

/// Makes triangles of the faces of a part anew.
/// @param deflection  how far they may stray from the surface
void tessellate(const DocumentPart&, double deflection);

/// Whether a face of a part that was tessellated has no triangles.
[[nodiscard]] bool lacksTriangles(const DocumentPart&);

/// The triangles of a part that was tessellated, with what is known of the surfaces that they stand for. Those that
/// stray from them by more than the deflection, as BRepMesh leaves some, are divided.
[[nodiscard]] Part meshOf(const DocumentPart&, double deflection);

/// The corners of the triangles of a part that was tessellated.
[[nodiscard]] std::vector<glm::dvec3> pointsOf(const DocumentPart&);

/// Scales the shape of a part that is tiny or huge: BRepMesh of OpenCASCADE 7.6 never ends on tori of 0.02 mm or 200 m,
/// and refuses deflections under 1e-7 mm.
void bringToUsualSize(DocumentPart&);

/// The corners of a box around a part; it may be too large. Empty: the part has no faces.
[[nodiscard]] std::vector<glm::dvec3> boxOf(const DocumentPart&);

}  // namespace inkedge::cad
