#include "formats/cad/occt_healing.h"

#include <IGESGeom_TrimmedSurface.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Wire.hxx>
#include <StepShape_Face.hxx>

namespace inkedge::cad {
namespace {

constexpr int manyWires = 64;  // of a face: up to here the search takes less than a fifth of a second

class QuickTools final : public ShapeAlgo_ToolContainer {
public:
    [[nodiscard]] Handle(ShapeFix_Shape) FixShape() const override {
        const Handle(ShapeFix_Shape) tool = ShapeAlgo_ToolContainer::FixShape();
        tool->FixWireTool()->FixSelfIntersectionMode() = 0;
        tool->FixFaceTool()->FixIntersectingWiresMode() = 0;
        return tool;
    }
};

int wiresOf(const Handle(Standard_Transient) & entity) {
    if (const auto face = Handle(StepShape_Face)::DownCast(entity); !face.IsNull()) return face->NbBounds();
    const auto surface = Handle(IGESGeom_TrimmedSurface)::DownCast(entity);
    return surface.IsNull() ? 0 : 1 + surface->NbInnerContours();
}

bool hasManyWires(const Interface_InterfaceModel& model) {
    for (int i = 1; i <= model.NbEntities(); ++i)
        if (wiresOf(model.Value(i)) > manyWires) return true;
    return false;
}

}  // namespace

bool setHealing(Healing healing, const Handle(Interface_InterfaceModel) & model) {
    const bool quick = healing == Healing::Quick && !model.IsNull() && hasManyWires(*model);
    ShapeAlgo::AlgoContainer()->SetToolContainer(quick ? new QuickTools : new ShapeAlgo_ToolContainer);
    return quick;
}

}  // namespace inkedge::cad
