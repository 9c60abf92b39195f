#include "formats/cad/load_cad.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "base/stop.h"
#include "formats/cad/file_ends.h"
#include "formats/cad/fineness.h"
#include "formats/cad/model.h"
#include "formats/cad/pack.h"
#include "formats/cad/request.h"
#include "formats/cad/surfaces.h"
#include "modules/failure.h"
#include "modules/open_module.h"
#include "process/child_program.h"

namespace inkedge::cad {
namespace {

constexpr modules::Module cadProgram{
    .purpose = "CAD files",
    .file = "inkedge_cad",
    .symbol = nullptr,
    .library = "OpenCASCADE",
    .option = "INKEDGE_CAD",
    .remedy = "export the model as glTF or STL",
};
constexpr modules::Module threeMfProgram{
    .purpose = "3MF files",
    .file = "inkedge_3mf",
    .symbol = nullptr,
    .library = "lib3mf",
    .option = "INKEDGE_3MF",
    .remedy = "export the model as glTF or STL",
};

const modules::Module& programOf(FileKind kind) { return kind == FileKind::ThreeMf ? threeMfProgram : cadProgram; }

// Adds what remedy there is to what was found of the program.
Error described(const Error& error, const modules::Module& program) {
    if (error.kind() != Error::Kind::Input) return error;
    const std::string what = error.what();
    const bool late = what.starts_with("found it still");
    return Error{Error::Kind::Input, fmt::format("expected a model that {} reads, {}{}", program.library, what,
                                                 late ? "; raise max-reading-time if the file is whole"
                                                      : ", most likely over a damaged file")};
}

// Without triangles. Of some damaged files OpenCASCADE reads for ever.
std::chrono::duration<double> longestReading(std::size_t bytes, const LoadLimits& limits) {
    constexpr double start = 4.0;         // seconds
    constexpr double perMegabyte = 30.0;  // many times what large files take
    const double share = std::max(1.0, limits.readingTime / LoadLimits{}.readingTime);
    const double reading = share * (start + perMegabyte * 1e-6 * static_cast<double>(bytes));
    return std::chrono::duration<double>{std::min(limits.readingTime, reading)};
}

Model readBy(FileKind kind, std::span<const std::uint8_t> bytes, glm::dvec3 up, const LoadSettings& settings) {
    const modules::Module& program = programOf(kind);
    const auto path = modules::findModule(program, Error::Kind::Input);
    const LoadLimits& limits = settings.limits;
    const Request request{std::string{nameOf(kind)}, limits.vertices, limits.instances, limits.nodes};
    process::ChildProgram child{path, request.arguments(), bytes, longestReading(bytes.size(), limits),
                                base::stopIfAsked};
    const auto receive = [&] {
        try {
            return child.receive();
        } catch (const Error& error) {
            throw described(error, program);
        }
    };
    while (true) {
        const auto outline = modules::expectNoFailure(unpacked<Outline>(receive()), Error::Kind::Input);
        child.setLimit(std::chrono::duration<double>{limits.readingTime});
        if (outline.ready) return unpacked<Model>(receive());
        child.send(packed(finenessFor(outline, up, settings)));
    }
}

EdgeKinds kindsOf(std::uint8_t bits) {
    EdgeKinds kinds;
    for (const EdgeKind kind : {EdgeKind::Inner, EdgeKind::Sharp, EdgeKind::Tangent, EdgeKind::Seam, EdgeKind::Free})
        if ((bits & static_cast<std::uint8_t>(kind)) != 0) kinds |= kind;
    return kinds;
}

Mesh meshOf(Part part) {
    Mesh mesh;
    mesh.name = std::move(part.name);
    mesh.origin = part.origin;
    mesh.positions = std::move(part.positions);
    mesh.normals = std::move(part.normals);
    mesh.indices = std::move(part.indices);
    mesh.materials = std::move(part.materials);
    mesh.faces = std::move(part.faces);
    mesh.parameters = std::move(part.parameters);
    if (!part.surfaces.empty()) mesh.surfaces = std::make_shared<const CadSurfaces>(std::move(part.surfaces));
    std::ranges::transform(part.edges, std::back_inserter(mesh.edges), kindsOf);
    return mesh;
}

// What is there but not drawn, in one line.
void warnOfUndrawn(Scene::Data& data) {
    if (data.undrawn.empty()) return;
    data.warnings.push_back(fmt::format("not drawn: {}", fmt::join(data.undrawn, ", ")));
}

Scene::Data dataOf(Model model, const std::string& name, const LoadSettings& settings) {
    Scene::Data data;
    if (model.nodes.size() == 1 && model.nodes.front().name.empty()) model.nodes.front().name = name;
    for (Node& node : model.nodes) data.nodes.push_back({std::move(node.name), node.parent});
    for (Part& part : model.parts) data.meshes.push_back(meshOf(std::move(part)));
    for (Mesh& mesh : data.meshes)
        if (mesh.name.empty() && data.meshes.size() == 1) mesh.name = name;
    for (cad::Instance& instance : model.instances) {
        inkedge::Instance& added = data.instances.emplace_back();
        added.name = instance.name.empty() && model.instances.size() == 1 ? name : std::move(instance.name);
        added.mesh = instance.part;
        added.node = instance.node;
        added.transform = instance.transform;
    }
    for (cad::Material& material : model.materials) {
        inkedge::Material& added = data.materials.emplace_back();
        added.name = std::move(material.name);
        added.color = material.color;
    }
    data.warnings = std::move(model.warnings);
    data.undrawn = std::move(model.undrawn);
    warnOfUndrawn(data);
    if (settings.subdivide > 0)
        data.warnings.emplace_back("is not subdivided: its curved surfaces are as smooth as tolerance asks for");
    return data;
}

// AP242 has it; OpenCASCADE reads it from 7.7 on.
bool holdsTessellationAlone(const Model& model, std::string_view text) {
    if (std::ranges::any_of(model.parts, [](const Part& part) { return !part.indices.empty(); })) return false;
    constexpr std::array<std::string_view, 4> items{"TESSELLATED_SOLID", "TESSELLATED_SHELL", "TRIANGULATED_FACE",
                                                    "TRIANGULATED_SURFACE_SET"};
    return std::ranges::any_of(items, [&](std::string_view item) { return text.find(item) != std::string_view::npos; });
}

Scene::Data load(const formats::ModelInput& input, FileKind kind, const LoadSettings& settings) {
    return base::within(input.where(), [&] {
        try {
            std::uint64_t bytesLeft = settings.limits.fileSize;
            const formats::Content content{input, bytesLeft};
            expectWhole(base::textOf(content.bytes()), kind, settings.limits.fileSize);
            constexpr glm::dvec3 zUp{0.0, 0.0, 1.0};
            Model model = readBy(kind, content.bytes(), settings.up.value_or(zUp), settings);
            if (holdsTessellationAlone(model, base::textOf(content.bytes())))
                model.undrawn.emplace_back("tessellated geometry, which OpenCASCADE does not read here");
            return dataOf(std::move(model), input.name.stem().string(), settings);
        } catch (const std::bad_alloc&) {
            base::refuse("expected a model that fits into memory, found one that does not");
        }
    });
}

}  // namespace

Scene::Data loadStep(const formats::ModelInput& input, const LoadSettings& settings) {
    return load(input, FileKind::Step, settings);
}
Scene::Data loadIges(const formats::ModelInput& input, const LoadSettings& settings) {
    return load(input, FileKind::Iges, settings);
}
Scene::Data loadBrep(const formats::ModelInput& input, const LoadSettings& settings) {
    return load(input, FileKind::Brep, settings);
}
Scene::Data loadThreeMf(const formats::ModelInput& input, const LoadSettings& settings) {
    return load(input, FileKind::ThreeMf, settings);
}

}  // namespace inkedge::cad
