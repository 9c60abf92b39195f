#pragma once

#include <cstdint>

#include <inkedge/mesh.h>
#include <inkedge/views.h>
#include "formats/implicit/scalar_field.h"

namespace inkedge::implicit {

/// What a surface is made of.
struct Grain {
    Box bounds;
    double deflection = 0.0;        ///< how far triangles may stray from the surface
    std::uint64_t maxElements = 0;  ///< vertices and indices
};

/// The surface where a field is 0, within bounds, where it ends; its front is where the field is over 0. Vertices lie
/// on the surface, to rounding, and have its normals, the gradients of the field.
///
/// The bounds are parted into cubes, and those that the surface passes through into as many as the deflection asks for;
/// each is parted into six tetrahedra (Bloomenthal 1994). What is smaller than a 64th of the longest side may be
/// missed.
/// @throws Error  (Kind::Input) if the field is not finite somewhere, or 0 nowhere, or there are more elements than may
///                be; the message says where
[[nodiscard]] Mesh polygonise(const ScalarField&, const Grain&);

}  // namespace inkedge::implicit
