#include <inkedge/load_scene.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#ifdef INKEDGE_CAD_FILES
#include "formats/cad/cad_files.h"
#endif
#ifdef INKEDGE_3MF_FILES
#include "formats/cad/threemf_files.h"
#endif
#include "formats/gltf/gltf_files.h"
#include "formats/reader.h"

namespace inkedge::formats {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1.5\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl red\nf 1/1 2/2 3/3 4/4\nusemtl blue\nf 1/1 2/2 5/3\nl 1 2\n";
const std::string textStl =
    "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid one\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "100 0 0\n101 0 0\n101 1 0\n100 1 0\n4 0 1 2 3\n";

std::string binaryStl() {
    std::string bytes(80, ' ');
    bytes += std::string{"\1\0\0\0", 4};
    for (const float number : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F})
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    return bytes + std::string(2, '\0');
}

const std::string allExtensions =
    ".glb, .gltf, .obj, .stl, .ply, .step, .stp, .p21, .iges, .igs, .brep, .3mf or .implicit";

// A model of every format, and of each of its forms.
std::map<std::string, std::string> models() {
    std::map<std::string, std::string> all{
        {"whole.gltf", gltf_files::indexedTriangle().gltf()},
        {"Plain.OBJ", obj},
        {"text.stl", textStl},
        {"binary.stl", binaryStl()},
        {"text.ply", ply},
    };
#ifdef INKEDGE_CAD_FILES
    all.emplace("box.step", cad_files::step(cad_files::Shape::Box));
    all.emplace("box.igs", cad_files::iges(cad_files::Shape::Box));
    all.emplace("box.brep", cad_files::brep(cad_files::Shape::Box));
#endif
#ifdef INKEDGE_3MF_FILES
    const std::vector<std::uint8_t> cube = threemf_files::oneCube();
    all.emplace("cube.3mf", std::string{cube.begin(), cube.end()});
#endif
#ifdef INKEDGE_IMPLICIT_FILES
    all.emplace("ball.implicit", "bounds -2 -2 -2 2 2 2\nf = x^2 + y^2 + z^2 - 1\n");
#endif
    for (const std::string asset : {"vase.glb", "boxes.glb", "primitives.glb", "lantern.glb"})
        all.emplace(asset, contents(fs::path{INKEDGE_SOURCE_DIR} / "assets" / asset));
    return all;
}

LoadSettings everything() {
    LoadSettings settings;
    settings.textureCoordinates = true;
    settings.paint = true;
    settings.curvature = true;
    return settings;
}

void expectSame(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.indices, b.indices);
    EXPECT_EQ(a.materials, b.materials);
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.lines, b.lines);
    EXPECT_EQ(a.textureCoordinates, b.textureCoordinates);
    EXPECT_EQ(a.curvatures, b.curvatures);
    ASSERT_EQ(a.paint.size(), b.paint.size());
    for (std::size_t i = 0; i < a.paint.size(); ++i) {
        EXPECT_EQ(a.paint[i].color, b.paint[i].color);
        EXPECT_EQ(a.paint[i].uv, b.paint[i].uv);
    }
}

void expectSame(const Material& a, const Material& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.doubleSided, b.doubleSided);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.wrap, b.wrap);
    ASSERT_EQ(a.picture == nullptr, b.picture == nullptr);
    if (a.picture) {
        EXPECT_EQ(a.picture->pixels(), b.picture->pixels());
    }
}

void expectSame(const SceneSource& a, const SceneSource& b) {
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.scenes, b.scenes);
    EXPECT_EQ(a.animations, b.animations);
    EXPECT_EQ(a.extensions, b.extensions);
    EXPECT_EQ(a.unit, b.unit);
    EXPECT_EQ(a.knowsSides, b.knowsSides);
}

void expectSame(const Scene& a, const Scene& b) {
    expectSame(a.source(), b.source());
    EXPECT_EQ(a.warnings(), b.warnings());
    ASSERT_EQ(a.meshes().size(), b.meshes().size());
    for (std::size_t i = 0; i < a.meshes().size(); ++i) expectSame(a.meshes()[i], b.meshes()[i]);
    ASSERT_EQ(a.instances().size(), b.instances().size());
    for (std::size_t i = 0; i < a.instances().size(); ++i) {
        EXPECT_EQ(a.instances()[i].name, b.instances()[i].name);
        EXPECT_EQ(a.instances()[i].mesh, b.instances()[i].mesh);
        EXPECT_EQ(a.instances()[i].transform, b.instances()[i].transform);
        EXPECT_EQ(a.instances()[i].node, b.instances()[i].node);
    }
    ASSERT_EQ(a.materials().size(), b.materials().size());
    for (std::size_t i = 0; i < a.materials().size(); ++i) expectSame(a.materials()[i], b.materials()[i]);
    ASSERT_EQ(a.cameras().size(), b.cameras().size());
    for (std::size_t i = 0; i < a.cameras().size(); ++i) {
        EXPECT_EQ(a.cameras()[i].name, b.cameras()[i].name);
        EXPECT_EQ(a.cameras()[i].transform, b.cameras()[i].transform);
    }
    ASSERT_EQ(a.nodes().size(), b.nodes().size());
    for (std::size_t i = 0; i < a.nodes().size(); ++i) EXPECT_EQ(a.nodes()[i].name, b.nodes()[i].name);
    EXPECT_EQ(a.box().min, b.box().min);
    EXPECT_EQ(a.box().max, b.box().max);
}

class LoadScene : public testing::Test {
protected:
    // The scene of a file that is there only meanwhile.
    [[nodiscard]] Scene fromFile(const std::string& name, const std::string& content) const {
        put(folder_ / name, content);
        Scene scene = loadScene(folder_ / name, everything());
        fs::remove(folder_ / name);
        return scene;
    }

    TemporaryFolder folder_;
};

Scene fromMemory(const std::string& content, const fs::path& name) {
    return loadScene(bytesOf(content), name, everything());
}

std::string refusalOf(const std::string& content, const fs::path& name) {
    try {
        static_cast<void>(fromMemory(content, name));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
        return error.what();
    }
    return "accepted";
}

// ---- the table

TEST_F(LoadScene, everyFormatHasAModelHere) {
    std::set<std::string_view> known;
    for (const ModelFormat& format : readableFormats()) known.insert(format.name);
    std::set<std::string_view> extensions;
    for (const ModelFormat& format : readableFormats())
        extensions.insert(format.extensions.begin(), format.extensions.end());
    std::set<std::string> read;
    for (const auto& [name, content] : models()) read.insert(fromFile(name, content).source().format);
#ifndef INKEDGE_CAD_FILES
    read.insert({"STEP", "IGES", "BREP"});
#endif
#ifndef INKEDGE_3MF_FILES
    read.insert("3MF");
#endif
#ifndef INKEDGE_IMPLICIT_FILES
    read.insert("implicit surface");
#endif
    EXPECT_THAT(read, testing::ElementsAreArray(known));
    EXPECT_THAT(extensions, ElementsAre(".3mf", ".brep", ".glb", ".gltf", ".iges", ".igs", ".implicit", ".obj", ".p21",
                                        ".ply", ".step", ".stl", ".stp"));
}

TEST_F(LoadScene, knowsOfEachFormatWhatItSays) {
    for (const auto& [name, content] : models()) {
        SCOPED_TRACE(name);
        const bool isGltf = name.ends_with(".glb") || name.ends_with(".gltf");
        const SceneSource source = fromFile(name, content).source();
        EXPECT_EQ(source.format == "glTF 2.0", isGltf);
        EXPECT_EQ(source.knowsSides, isGltf);
        const bool isCad = std::set<std::string>{"STEP", "IGES", "BREP", "3MF"}.contains(source.format);
        EXPECT_EQ(source.unit, isGltf ? LengthUnit::Metre : isCad ? LengthUnit::Millimetre : LengthUnit::None);
    }
}

TEST_F(LoadScene, isChosenByExtensionInAnyCase) {
    for (const auto& [name, content] :
         std::map<std::string, std::string>{{"a.obj", obj}, {"b.OBJ", obj}, {"c.Stl", textStl}, {"d.PLY", ply}})
        EXPECT_GT(fromFile(name, content).triangleCount(), 0U) << name;
}

TEST_F(LoadScene, isChosenByFirstBytesWhereTheExtensionIsNoFormats) {
    const std::string glb = gltf_files::triangle().glb();
    for (const std::string name : {"a.dat", "b"}) {
        EXPECT_EQ(fromFile(name, ply).source().format, "PLY");
        EXPECT_EQ(fromFile(name, textStl).source().format, "STL");
        EXPECT_EQ(fromFile(name, glb).source().format, "glTF 2.0");
    }
}

TEST_F(LoadScene, binaryGltfIsReadWhateverTheExtension) {
    EXPECT_EQ(fromFile("a.obj", gltf_files::triangle().glb()).source().format, "glTF 2.0");
    EXPECT_THAT(refusalOf("glTF....", "a.obj"), HasSubstr("expected a .glb"));
}

TEST_F(LoadScene, theExtensionDecidesAgainstFirstBytesThatMayStandInAnyFile) {
    EXPECT_THAT(refusalOf(ply, "a.obj"), StartsWith("a.obj: "));
    EXPECT_THAT(refusalOf(ply, "a.glb"), HasSubstr("expected glTF 2.0 (.glb or .gltf), found a PLY file"));
    std::string stl = binaryStl();
    stl.replace(0, 4, "ply\n");
    EXPECT_EQ(fromFile("a.stl", stl).source().format, "STL");
}

TEST_F(LoadScene, namesTheFormatsWhereNeitherSaysOne) {
    for (const std::string name : {"a.txt", "b"}) {
        const fs::path file = folder_ / name;
        put(file, obj);
        expectError(Error::Kind::Input,
                    file.string() + ": expected a model by its extension, " + allExtensions +
                        ", found other text with " + (name == "b" ? "none" : ".txt"),
                    [&] { static_cast<void>(loadScene(file)); });
    }
    for (const char* const name : {"missing.txt", "missing.glb", "missing.obj", "missing"})
        expectError(Error::Kind::Input, (folder_ / name).string() + ": expected a file, found none",
                    [&] { static_cast<void>(loadScene(folder_ / name)); });
}

// ---- memory

TEST_F(LoadScene, bytesGiveTheSceneThatTheirFileGives) {
    for (const auto& [name, content] : models()) {
        SCOPED_TRACE(name);
        expectSame(fromFile(name, content), fromMemory(content, folder_ / name));
    }
}

TEST_F(LoadScene, bytesNameTheirMeshAsAFileOfTheNameWould) {
    EXPECT_EQ(fromMemory(ply, "folder/part.ply").meshes().at(0).name, "part");
    EXPECT_EQ(fromMemory(ply, "").meshes().at(0).name, "");
}

TEST_F(LoadScene, bytesWithoutANameAreKnownByTheirStart) {
    EXPECT_EQ(fromMemory(ply, "").source().format, "PLY");
    EXPECT_EQ(fromMemory(textStl, "").source().format, "STL");
    EXPECT_EQ(fromMemory(gltf_files::triangle().glb(), "").source().format, "glTF 2.0");
    EXPECT_EQ(refusalOf(obj, ""),
              "model in memory: expected a model by its extension, " + allExtensions +
                  ", found other text with none; say which it is: --format, or a name in the library");
}

TEST_F(LoadScene, aWrongNameIsRefusedByTheReaderThatItNames) {
    EXPECT_THAT(refusalOf(textStl, "part.ply"), StartsWith("part.ply: expected PLY, found an STL file"));
    EXPECT_THAT(refusalOf(obj, "part.stl"), StartsWith("part.stl: expected STL, found other text"));
    EXPECT_THAT(refusalOf(obj, "part.gltf"), StartsWith("part.gltf: expected glTF 2.0 (.glb or .gltf), found other"));
    EXPECT_THAT(refusalOf(obj, "part.png"), AllOf(StartsWith("part.png: expected a model by its extension"),
                                                  testing::HasSubstr("found other text with .png; say which it is")));
}

TEST_F(LoadScene, noBytesAreRefused) {
    for (const ModelFormat& format : readableFormats())
        for (const std::string_view extension : format.extensions) {
            const std::string name = "part" + std::string{extension};
            EXPECT_EQ(refusalOf("", name), name + ": expected the bytes of a model, found none");
        }
    EXPECT_EQ(refusalOf("", ""), "model in memory: expected the bytes of a model, found none");
}

TEST_F(LoadScene, bytesOverTheLimitAreRefused) {
    LoadSettings settings;
    settings.limits.fileSize = ply.size();
    EXPECT_EQ(loadScene(bytesOf(ply), "a.ply", settings).triangleCount(), 2U);
    --settings.limits.fileSize;
    expectError(Error::Kind::Input, AllOf(StartsWith("a.ply: "), HasSubstr("raise max-file-size")),
                [&] { static_cast<void>(loadScene(bytesOf(ply), "a.ply", settings)); });
}

TEST_F(LoadScene, gltfInMemoryMayNameNoBuffersFile) {
    gltf_files::Model model = gltf_files::triangle();
    model.json["buffers"] = {{{"byteLength", model.bytes.size()}, {"uri", "beside.bin"}}};
    put(folder_ / "beside.bin", {model.bytes.begin(), model.bytes.end()});
    EXPECT_EQ(fromFile("a.gltf", model.gltf()).triangleCount(), 1U);
    EXPECT_EQ(refusalOf(model.gltf(), folder_ / "a.gltf"),
              (folder_ / "a.gltf").string() +
                  ": buffer 0: expected all data within a model in memory, embedded or as data URIs, found the file "
                  "'beside.bin'");
}

TEST_F(LoadScene, gltfInMemoryIsDrawnWithoutAPictureInAFile) {
    gltf_files::Model model = gltf_files::indexedTriangle();
    model.add("images", {{"uri", "beside.png"}});
    model.add("textures", {{"source", 0}});
    model.add("materials", {{"name", "paint"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    model.json["meshes"][0]["primitives"][0]["material"] = 0;
    const Scene scene = fromMemory(model.gltf(), "a.gltf");
    EXPECT_THAT(scene.warnings(),
                ElementsAre("material 0 'paint' is drawn without its picture: image 0: expected all data within a "
                            "model in memory, embedded or as data URIs, found the file 'beside.png'"));
    EXPECT_EQ(scene.materials().at(0).picture, nullptr);
}

TEST_F(LoadScene, bytesThatDrawNothingAreRefusedByTheirName) {
    EXPECT_EQ(refusalOf("v 0 0 0\nv 1 0 0\np 1\n", "a.obj"),
              "a.obj: expected at least one triangle or line to draw, found none: 1 point");
}

}  // namespace
}  // namespace inkedge::formats
