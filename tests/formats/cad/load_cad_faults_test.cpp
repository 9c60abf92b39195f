// CAD files that are refused, in one line.
#include "base/expect_error.h"
#include "formats/cad/cad_scenes.h"

namespace inkedge::cad {
namespace {

using testing::HasSubstr;

std::string refusalOf(const std::string& text, const std::string& name, const LoadSettings& settings = {}) {
    try {
        static_cast<void>(sceneOf(text, name, settings));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        return error.what();
    }
    return "none";
}

TEST(LoadCadFaults, refusesWhatIsNoModel) {
    const std::string step = cad_files::step(Shape::Cylinder);
    const std::string brep = cad_files::brep(Shape::Cylinder);
    EXPECT_EQ(refusalOf("hello", "a.step"), "a.step: expected ISO-10303-21 first in a STEP file, found other text");
    EXPECT_EQ(refusalOf(step.substr(0, step.size() / 2), "a.step"),
              "a.step: expected END-ISO-10303-21 last in a STEP file, found none: it is cut short");
    EXPECT_EQ(refusalOf(step.substr(0, step.size() / 2) + "\nENDSEC;\nEND-ISO-10303-21;\n", "a.step"),
              "a.step: expected STEP as ISO 10303-21 has it, found text that is not");
    EXPECT_THAT(refusalOf("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", "a.step"),
                HasSubstr("a.step: expected"));
    EXPECT_EQ(refusalOf(cad_files::iges(Shape::Box).substr(0, 2000), "a.igs"),
              "a.igs: expected a line of section T last in an IGES file, found none: it is cut short");
    EXPECT_EQ(refusalOf(brep.substr(0, brep.size() / 2), "a.brep"),
              "a.brep: expected the number of a shape, as in '+1 0', last in a BREP file, found none: it is cut short");
    EXPECT_EQ(refusalOf(brep.substr(20), "a.brep"),
              "a.brep: expected 'DBRep_DrawableShape' or 'CASCADE Topology' first in a BREP file, found other text");
}

TEST(LoadCadFaults, namesWhatItCannotRead) {
    const std::string text = cad_files::step(Shape::Box);
    EXPECT_EQ(refusalOf(replaced(text, "MANIFOLD_SOLID_BREP", "UNKNOWN_SOLID_BREP"), "a.step"),
              "a.step: expected at least one triangle or line to draw, found none");
    EXPECT_THAT(refusalOf(replaced(text, "MANIFOLD_SOLID_BREP", "TESSELLATED_SOLID"), "a.step"),
                HasSubstr("found none: tessellated geometry, which OpenCASCADE does not read here"));
}

TEST(LoadCadFaults, refusesWhatCrashesTheLibrary) {
    const std::string looped =
        replaced(mapped("$,$,#9023,1.,$"), "REPRESENTATION_MAP(#9010,#10)", "REPRESENTATION_MAP(#9010,#9000)");
    EXPECT_THAT(refusalOf(looped, "a.step"),
                HasSubstr("a.step: expected a model that OpenCASCADE reads, found a crash"));
}

TEST(LoadCadFaults, staysWithinItsLimits) {
    LoadSettings settings;
    settings.limits.vertices = 100;
    EXPECT_EQ(refusalOf(cad_files::step(Shape::Torus), "a.step", settings),
              "a.step: expected at most 100 vertices and indices, found more; raise max-vertices or tolerance");
    settings = {};
    settings.limits.readingTime = 0.001;
    const std::string late = refusalOf(cad_files::step(Shape::Box), "a.step", settings);
    EXPECT_THAT(late, HasSubstr("a.step: expected a model that OpenCASCADE reads, found it still at work after "));
    EXPECT_THAT(late, HasSubstr(" s; raise max-reading-time if the file is whole"));
    settings = {};
    settings.limits.fileSize = 10;
    EXPECT_THAT(refusalOf(cad_files::step(Shape::Box), "a.step", settings), HasSubstr("raise max-file-size"));
}

TEST(LoadCadFaults, refusesACameraThatTheFileHasNot) {
    CameraSettings ofTheFile;
    ofTheFile.index = 0;
    LoadSettings settings;
    settings.pictures.cameras = {ofTheFile};
    const std::string text = cad_files::step(Shape::Box);
    expectError(Error::Kind::Usage, HasSubstr("--camera-index: expected a camera of the file"),
                [&] { static_cast<void>(sceneOf(text, "a.step", settings)); });
}

}  // namespace
}  // namespace inkedge::cad
