#include "formats/cad/occt_mapped_items.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopLoc_Location.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "formats/cad/occt_vectors.h"

namespace inkedge::cad {
namespace {

using Direction = std::optional<glm::dvec3>;

Direction directionOf(const Handle(StepGeom_Direction) & source) {
    if (source.IsNull() || source->NbDirectionRatios() < 3) return {};
    const glm::dvec3 d{source->DirectionRatiosValue(1), source->DirectionRatiosValue(2),
                       source->DirectionRatiosValue(3)};
    const double length = glm::length(d);
    return length > 0.0 ? Direction{d / length} : Direction{};
}

glm::dvec3 pointOf(const Handle(StepGeom_CartesianPoint) & source) {
    if (source.IsNull() || source->NbCoordinates() < 3) return glm::dvec3{0.0};
    return {source->CoordinatesValue(1), source->CoordinatesValue(2), source->CoordinatesValue(3)};
}

// ISO 10303-42, base_axis: the third axis stays, the first is brought across it. Without a second one they are
// right-handed.
glm::dmat3 axesOf(const Direction& first, const Direction& second, const Direction& third) {
    const glm::dvec3 z = third.value_or(glm::dvec3{0.0, 0.0, 1.0});
    glm::dvec3 x = first.value_or(std::abs(z.x) < 0.9 ? glm::dvec3{1.0, 0.0, 0.0} : glm::dvec3{0.0, 1.0, 0.0});
    x -= glm::dot(x, z) * z;
    if (glm::length(x) < 1e-12) return glm::dmat3{1.0};
    x = glm::normalize(x);
    const glm::dvec3 y = glm::cross(z, x);
    return {x, second && glm::dot(*second, y) < 0.0 ? -y : y, z};
}

// A rotation, mirroring and scale, and where the origin goes, in the file's unit.
struct Frame {
    glm::dmat3 axes{1.0};
    glm::dvec3 origin{0.0};
};

Frame frameOf(const Handle(StepGeom_CartesianTransformationOperator3d) & source) {
    const auto direction = [](bool has, const Handle(StepGeom_Direction) & d) {
        return has ? directionOf(d) : Direction{};
    };
    const glm::dmat3 axes =
        axesOf(direction(source->HasAxis1(), source->Axis1()), direction(source->HasAxis2(), source->Axis2()),
               direction(source->HasAxis3(), source->Axis3()));
    const double scale = source->HasScale() ? source->Scale() : 1.0;
    return {scale * axes, pointOf(source->LocalOrigin())};
}

Frame frameOf(const Handle(StepGeom_Axis2Placement3d) & source) {
    const Direction z = source->HasAxis() ? directionOf(source->Axis()) : Direction{};
    const Direction x = source->HasRefDirection() ? directionOf(source->RefDirection()) : Direction{};
    return {axesOf(x, {}, z), pointOf(source->Location())};
}

// The rotation that OpenCASCADE has for it.
glm::dmat3 rigid(const glm::dmat3& axes) {
    const glm::dvec3 z = glm::normalize(axes[2]);
    const glm::dvec3 x = glm::normalize(axes[0]);
    return {x, glm::cross(z, x), z};
}

// @param found  what OpenCASCADE makes of it, in millimetres
glm::dmat4 transformOf(const Frame& target, const Frame& origin, glm::dvec3 found) {
    const glm::dmat3 back = glm::inverse(origin.axes);
    const glm::dvec3 rigidTranslation = target.origin - rigid(target.axes) * back * origin.origin;
    const double square = glm::dot(rigidTranslation, rigidTranslation);
    const double millimetres = square > 0.0 ? glm::dot(found, rigidTranslation) / square : 1.0;
    const glm::dmat3 linear = target.axes * back;
    glm::dmat4 transform{linear};
    transform[3] = glm::dvec4{millimetres * (target.origin - linear * origin.origin), 1.0};
    return transform;
}

bool isRigid(const glm::dmat3& axes) {
    constexpr double rounding = 1e-9;
    return std::abs(glm::determinant(axes) - 1.0) < rounding;
}

std::string nameOf(const StepRepr_MappedItem& item) {
    const Handle(TCollection_HAsciiString) own = item.Name();
    if (!own.IsNull() && !own->IsEmpty()) return own->ToCString();
    const Handle(StepRepr_Representation) mapped = item.MappingSource()->MappedRepresentation();
    const Handle(TCollection_HAsciiString) name = mapped.IsNull() ? nullptr : mapped->Name();
    return name.IsNull() ? std::string{} : name->ToCString();
}

}  // namespace

std::vector<MappedShape> mappedShapes(const STEPControl_Reader& reader) {
    std::vector<MappedShape> found;
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    const Handle(Interface_InterfaceModel) model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(i));
        if (item.IsNull() || item->MappingSource().IsNull()) continue;
        const auto target = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(item->MappingTarget());
        const auto origin = Handle(StepGeom_Axis2Placement3d)::DownCast(item->MappingSource()->MappingOrigin());
        if (target.IsNull() || origin.IsNull()) continue;
        const Frame frame = frameOf(target);
        if (isRigid(frame.axes)) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, item);
        if (shape.IsNull()) continue;
        const glm::dvec3 translation = vectorOf(shape.Location().Transformation().TranslationPart());
        found.push_back({shape, transformOf(frame, frameOf(origin), translation), nameOf(*item)});
    }
    return found;
}

}  // namespace inkedge::cad
