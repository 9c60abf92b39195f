// What OpenCASCADE's own hidden-line removal takes, and finds: opencascade_hlr FILE... prints a JSON object a line.
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

class Stopwatch {
public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Reader>
TopoDS_Shape readBy(const std::string& file) {
    Reader reader;
    reader.ReadFile(file.c_str());
    reader.TransferRoots();
    return reader.OneShape();
}

TopoDS_Shape read(const std::string& file) {
    const std::string_view extension = std::string_view{file}.substr(file.find_last_of('.'));
    if (extension == ".step" || extension == ".stp") return readBy<STEPControl_Reader>(file);
    if (extension == ".iges" || extension == ".igs") return readBy<IGESControl_Reader>(file);
    TopoDS_Shape shape;
    BRep_Builder builder;
    BRepTools::Read(shape, file.c_str(), builder);
    return shape;
}

// Triangles that stray by a ten-thousandth of the model's size.
void tessellate(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    const double size = std::sqrt(box.SquareExtent());
    BRepMesh_IncrementalMesh{shape, 1e-4 * size, false, 0.5, false};
}

// Of all edges, in the picture's plane.
double lengthOf(TopoDS_Shape edges) {
    if (edges.IsNull()) return 0.0;
    BRepLib::BuildCurves3d(edges);
    double sum = 0.0;
    for (TopExp_Explorer edge{edges, TopAbs_EDGE}; edge.More(); edge.Next()) {
        try {
            sum += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve{TopoDS::Edge(edge.Current())});
        } catch (const Standard_Failure&) {  // an edge without a curve
        }
    }
    return sum;
}

// Of a part seen from the front, the right and above.
void measure(const std::string& file) {
    const Stopwatch reading;
    const TopoDS_Shape shape = read(file);
    const double read = reading.seconds();
    const Stopwatch meshing;
    tessellate(shape);
    const double mesh = meshing.seconds();
    const HLRAlgo_Projector projector{gp_Ax2{gp_Pnt{0, 0, 0}, gp_Dir{1, -1, 1}}};
    double exact = -1.0;
    double seen = 0.0;
    double hidden = 0.0;
    try {
        Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo;
        algorithm->Add(shape);
        algorithm->Projector(projector);
        const Stopwatch watch;
        algorithm->Update();
        algorithm->Hide();
        exact = watch.seconds();
        HLRBRep_HLRToShape lines{algorithm};
        seen = lengthOf(lines.OutLineVCompound()) + lengthOf(lines.VCompound()) + lengthOf(lines.Rg1LineVCompound());
        hidden = lengthOf(lines.OutLineHCompound()) + lengthOf(lines.HCompound()) + lengthOf(lines.Rg1LineHCompound());
    } catch (const Standard_Failure&) {
        exact = -1.0;
    }
    double polygonal = -1.0;
    try {
        Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo;
        algorithm->Load(shape);
        algorithm->Projector(projector);
        const Stopwatch watch;
        algorithm->Update();
        polygonal = watch.seconds();
    } catch (const Standard_Failure&) {
        polygonal = -1.0;
    }
    std::printf(R"({"read": %.4f, "mesh": %.4f, "exact": %.4f, "polygonal": %.4f, "seen": %.6g, "hidden": %.6g})"
                "\n",
                read, mesh, exact, polygonal, seen, hidden);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    for (int i = 1; i < count; ++i) measure(arguments[i]);
}
