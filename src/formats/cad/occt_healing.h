#pragma once

#include <Interface_InterfaceModel.hxx>
#include <Standard_Handle.hxx>

namespace inkedge::cad {

/// What OpenCASCADE looks for, to mend it, while it makes shapes of a STEP or IGES file.
enum class Healing {
    /// In models with a face of very many wires no wires that cross: the time for that grows with their number's
    /// square, 90 s for a plate with 1,000 holes. A face with such wires may get no triangles.
    Quick,
    Full,  ///< all that it does by default
};

/// Sets how models are mended from now on.
/// @return  whether this one is mended less than in full
[[nodiscard]] bool setHealing(Healing, const Handle(Interface_InterfaceModel) &);

}  // namespace inkedge::cad
