#pragma once

#include "formats/cad/occt_document.h"

namespace inkedge::cad {

/// Joins the faces of a part that share no edges along those that run along each other, as IGES files need it. What the
/// part says of its faces stays. Shells that are closed then are turned outward.
void sew(DocumentPart&);

}  // namespace inkedge::cad
