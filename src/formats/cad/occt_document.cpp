#include "formats/cad/occt_document.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepGeom_GeometricRepresentationItem.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include <inkedge/scene.h>

#include "formats/cad/occt_mapped_items.h"
#include "formats/cad/occt_sew.h"
#include "formats/cad/occt_vectors.h"

namespace inkedge::cad {
namespace {

std::string utf8(const TCollection_ExtendedString& text) {
    std::string result(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
    Standard_PCharacter to = result.data();
    text.ToUTF8CString(to);
    result.resize(result.find('\0'));
    return result;
}

// The name that the file gives; OpenCASCADE makes up those of references and of shapes.
std::string nameOf(const TDF_Label& label) {
    Handle(TDataStd_Name) found;
    if (!label.FindAttribute(TDataStd_Name::GetID(), found)) return {};
    std::string name = utf8(found->Get());
    constexpr std::array<std::string_view, 7> made{"COMPOUND", "COMPSOLID", "SOLID", "SHELL",
                                                   "FACE",     "ASSEMBLY",  "ASM"};
    if (name.starts_with("=>[") || std::ranges::find(made, name) != made.end()) return {};
    return name;
}

// What XDE has of a file, as a tree of names with instances.
class Walk {
public:
    /// @param mapped  shapes that stand otherwise than the document says
    Walk(const Handle(TDocStd_Document) & document, std::vector<MappedShape> mapped, const Request& limits)
        : limits_{limits},
          mapped_{std::move(mapped)},
          shapes_{XCAFDoc_DocumentTool::ShapeTool(document->Main())},
          colors_{XCAFDoc_DocumentTool::ColorTool(document->Main())},
          layers_{XCAFDoc_DocumentTool::LayerTool(document->Main())} {}

    Document walk() {
        TDF_LabelSequence roots;
        shapes_->GetFreeShapes(roots);
        for (const TDF_Label& root : roots) visit(root, glm::dmat4{1.0}, noNode, {}, {});
        warnOfMapped();
        return std::move(document_);
    }

private:
    using Color = std::optional<Quantity_ColorRGBA>;

    void visit(const TDF_Label& label, const glm::dmat4& outer, std::uint32_t parent, std::string name, Color color) {
        if (!isVisible(label)) {
            ++document_.invisible;
            return;
        }
        const Color own = colorOf(label);
        if (own) color = own;
        if (name.empty()) name = nameOf(label);
        TDF_Label referred;
        if (XCAFDoc_ShapeTool::GetReferredShape(label, referred))
            return visit(referred, outer * transformOf(label), parent, name, color);
        const auto node = static_cast<std::uint32_t>(document_.model.nodes.size());
        document_.model.nodes.push_back({name, parent});
        limits_.expectNodes(document_.model.nodes.size());
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(label, components);
        if (components.IsEmpty() || areFaces(components)) return addInstance(label, outer, node, name, color);
        for (const TDF_Label& component : components) visit(component, outer, node, {}, color);
    }

    [[nodiscard]] glm::dmat4 transformOf(const TDF_Label& component) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(component);
        const auto mapped = std::ranges::find_if(
            mapped_, [&](const MappedShape& each) { return !each.taken && each.shape.IsSame(shape); });
        if (mapped == mapped_.end()) return matrixOf(XCAFDoc_ShapeTool::GetLocation(component).Transformation());
        mapped->taken = true;
        return mapped->transform;
    }

    void warnOfMapped() {
        for (const MappedShape& mapped : mapped_)
            if (!mapped.taken)
                document_.model.warnings.push_back(fmt::format(
                    "'{}' is drawn without the mirroring or the scale that a MAPPED_ITEM asks for", mapped.name));
    }

    // Whether the components of an assembly are single faces: a surface that was taken to pieces.
    [[nodiscard]] static bool areFaces(const TDF_LabelSequence& components) {
        return components.Length() > 1 &&
               std::all_of(components.begin(), components.end(), [](const TDF_Label& component) {
                   TopTools_IndexedMapOfShape faces;
                   const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(component);
                   if (shape.IsNull() || shape.ShapeType() == TopAbs_SOLID) return false;
                   TopExp::MapShapes(shape, TopAbs_FACE, faces);
                   return faces.Extent() == 1;
               });
    }

    void addInstance(const TDF_Label& label, const glm::dmat4& outer, std::uint32_t node, const std::string& name,
                     const Color& color) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
        const std::uint32_t material = color ? materialOf(*color) : 0;
        const auto [entry, isNew] = parts_.try_emplace({label.Tag(), material}, document_.parts.size());
        const std::string own = nameOf(label);
        if (isNew) addPart(label, shape, material, own.empty() ? name : own);
        document_.model.instances.push_back({name, static_cast<std::uint32_t>(entry->second), node, outer});
        limits_.expectInstances(document_.model.instances.size());
    }

    void addPart(const TDF_Label& label, const TopoDS_Shape& shape, std::uint32_t material, const std::string& name) {
        DocumentPart part{name, shape, material};
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        part.materials.assign(static_cast<std::size_t>(faces.Extent()), 0);
        part.invisible.assign(static_cast<std::size_t>(faces.Extent()), false);
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(label, components);
        for (const TDF_Label& component : components) {
            TDF_Label referred;
            XCAFDoc_ShapeTool::GetReferredShape(component, referred);
            for (const TDF_Label& each : {referred, component})
                paint(each, XCAFDoc_ShapeTool::GetShape(component), faces, part);
        }
        TDF_LabelSequence labels;
        XCAFDoc_ShapeTool::GetSubShapes(label, labels);
        for (const bool ofFaces : {false, true}) {  // what is said of a face itself comes last
            for (const TDF_Label& sub : labels) {
                const TopoDS_Shape subShape = XCAFDoc_ShapeTool::GetShape(sub);
                if (subShape.IsNull() || (subShape.ShapeType() == TopAbs_FACE) != ofFaces) continue;
                if (subShape.ShapeType() <= TopAbs_FACE) paint(sub, subShape, faces, part);
            }
        }
        document_.parts.push_back(std::move(part));
    }

    void paint(const TDF_Label& label, const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces,
               DocumentPart& part) {
        const Color color = colorOf(label);
        const bool visible = isVisible(label);
        if (!visible) ++document_.invisible;
        if (visible && !color) return;
        for (TopExp_Explorer face{shape, TopAbs_FACE}; face.More(); face.Next()) {
            const int number = faces.FindIndex(face.Current());
            if (number == 0) continue;
            const auto i = static_cast<std::size_t>(number - 1);
            if (color) part.materials[i] = materialOf(*color);
            if (!visible) part.invisible[i] = true;
        }
    }

    [[nodiscard]] bool isVisible(const TDF_Label& label) const {
        if (!colors_->IsVisible(label)) return false;
        TDF_LabelSequence layers;
        layers_->GetLayers(label, layers);
        return std::all_of(layers.begin(), layers.end(),
                           [&](const TDF_Label& layer) { return layers_->IsVisible(layer); });
    }

    [[nodiscard]] Color colorOf(const TDF_Label& label) const {
        Quantity_ColorRGBA color;
        for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
            if (colors_->GetColor(label, type, color)) return color;
        return {};
    }

    std::uint32_t materialOf(const Quantity_ColorRGBA& color) {
        const Quantity_Color& rgb = color.GetRGB();
        const std::tuple key{rgb.Red(), rgb.Green(), rgb.Blue()};
        const auto [entry, isNew] = materials_.try_emplace(key, static_cast<std::uint32_t>(materials_.size() + 1));
        if (isNew)
            document_.model.materials.push_back({{},
                                                 {static_cast<float>(rgb.Red()), static_cast<float>(rgb.Green()),
                                                  static_cast<float>(rgb.Blue()), 1.0F}});
        return entry->second;
    }

    const Request& limits_;
    std::vector<MappedShape> mapped_;
    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colors_;
    Handle(XCAFDoc_LayerTool) layers_;
    std::map<std::pair<int, std::uint32_t>, std::size_t> parts_;  // by label and colour
    std::map<std::tuple<double, double, double>, std::uint32_t> materials_;
    Document document_;
};

Handle(TDocStd_Document) newDocument() {
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    return document;
}

// Not notes, tolerances and the like, which are not drawn in any case.
bool isOfShapes(const Handle(Standard_Transient) & entity) {
    return !entity.IsNull() && (entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem)) ||
                                entity->IsKind(STANDARD_TYPE(StepGeom_GeometricRepresentationItem)) ||
                                entity->IsKind(STANDARD_TYPE(IGESData_IGESEntity)));
}

// How many items of the file could not be read, or no shapes be made of.
std::uint64_t failuresOf(const XSControl_WorkSession& session) {
    std::uint64_t count = 0;
    const Handle(Interface_InterfaceModel)& model = session.Model();
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (model->IsErrorEntity(i) && isOfShapes(model->Value(i))) ++count;
    Interface_CheckIterator checks = session.TransferReader()->LastCheckList();
    for (checks.Start(); checks.More(); checks.Next())
        if (checks.Value()->HasFailed() && isOfShapes(checks.Value()->Entity())) ++count;
    return count;
}

Document readStep(const char* file, Healing healing, const Request& limits) {
    STEPCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(file) != IFSelect_RetDone)
        throw std::runtime_error{"expected STEP as ISO 10303-21 has it, found text that is not"};
    const bool mendedLess = setHealing(healing, reader.Reader().Model());
    Handle(TDocStd_Document) document = newDocument();
    reader.Transfer(document);
    Document read = Walk{document, mappedShapes(reader.Reader()), limits}.walk();
    read.unreadable = failuresOf(*reader.Reader().WS());
    read.mendedLess = mendedLess;
    return read;
}

Document readIges(const char* file, Healing healing, const Request& limits) {
    IGESCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(file) != IFSelect_RetDone)
        throw std::runtime_error{"expected IGES as its standard has it, found text that is not"};
    const bool mendedLess = setHealing(healing, reader.Model());
    Handle(TDocStd_Document) document = newDocument();
    reader.Transfer(document);
    Document read = Walk{document, {}, limits}.walk();
    read.unreadable = failuresOf(*reader.WS());
    read.mendedLess = mendedLess;
    return read;
}

Document readBrep(const char* file) {
    TopoDS_Shape shape;
    const BRep_Builder builder;
    std::ifstream start{file};
    std::string first;
    std::getline(start, first);
    start.close();
    const bool binary = first.find("Open CASCADE Topology") != std::string::npos;
    const bool read = binary ? BinTools::Read(shape, file) : BRepTools::Read(shape, file, builder);
    if (!read || shape.IsNull())
        throw std::runtime_error{"expected BREP as OpenCASCADE writes it, found text that is not"};
    Document document;
    document.model.nodes.push_back({{}, noNode});
    document.parts.push_back({{}, shape});
    document.model.instances.push_back({});
    return document;
}

// What belongs to no face, of an instance's part.
void countLoose(const TopoDS_Shape& shape, Document& document) {
    for (TopExp_Explorer edge{shape, TopAbs_EDGE, TopAbs_FACE}; edge.More(); edge.Next()) ++document.curves;
    for (TopExp_Explorer vertex{shape, TopAbs_VERTEX, TopAbs_EDGE}; vertex.More(); vertex.Next()) ++document.points;
}

}  // namespace

Document readDocument(const char* file, CadFormat format, Healing healing, const Request& limits) {
    Document document = format == CadFormat::Step   ? readStep(file, healing, limits)
                        : format == CadFormat::Iges ? readIges(file, healing, limits)
                                                    : readBrep(file);
    for (DocumentPart& part : document.parts) {
        countLoose(part.shape, document);
        sew(part);
    }
    return document;
}

}  // namespace inkedge::cad
