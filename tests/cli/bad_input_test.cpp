// Bad input and bad places: one clear line, the right exit code, nothing left behind.
#include "cli/command.h"

namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

class BadInput : public Command {
protected:
    void TearDown() override { EXPECT_THAT(folder_.names(), IsEmpty()) << "a failure must leave nothing behind"; }

    void expectUsageFailure(const Arguments& flags, const std::string& text) const {
        expectFailure(render(roof(), flags), 2, HasSubstr(text));
    }
    void expectUnreadable(const std::string& model, const std::string& text) const {
        const Outcome outcome = render(model);
        expectFailure(outcome, 3, HasSubstr(text));
        EXPECT_THAT(outcome.error, HasSubstr(model)) << "the file is named";
    }
};

TEST_F(BadInput, ModelThatIsMissing) { expectUnreadable("missing.glb", "expected a file, found none"); }

TEST_F(BadInput, ModelThatIsAFolder) { expectUnreadable(models_.path(), "expected a file, found a folder"); }

TEST_F(BadInput, ModelThatIsAPicture) {
    expectUnreadable(file("picture.glb", "\x89PNG\r\n\x1a\n" + std::string(100, '\0')), "found a PNG");
}

TEST_F(BadInput, ModelThatIsText) { expectUnreadable(file("notes.glb", "hello there\n"), "expected glTF 2.0"); }

TEST_F(BadInput, ModelThatIsEmpty) { expectUnreadable(file("nothing.glb", ""), ", found an empty one"); }

TEST_F(BadInput, ModelThatIsTruncatedAnywhere) {
    const std::string whole = contents(asset("cube.glb"));
    for (const std::size_t length :
         {std::size_t{5}, std::size_t{12}, std::size_t{19}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
        expectUnreadable(file("truncated.glb", whole.substr(0, length)), "truncated");
    }
}

TEST_F(BadInput, ModelWithoutTriangles) { expectUnreadable(emptyModel(), "triangle"); }

TEST_F(BadInput, PositionThatIsNotANumber) { expectUnreadable(roofWithoutNumber(), "finite"); }

TEST_F(BadInput, PictureWithoutPixels) {
    for (const char* size : {"0x10", "10x0", "0x0"}) {
        expectUsageFailure({"--size", size}, "--size: expected 1x1 to 32768x32768 pixels, found '");
    }
}

TEST_F(BadInput, PictureOverTheLimit) {
    expectUsageFailure({"--size", "32769x10"}, "--size: expected 1x1 to 32768x32768 pixels, found '32769x10'");
    expectUsageFailure({"--size", "10x2147483647"}, "found '10x2147483647'");
    expectUsageFailure({"--size", "99999999999x10"}, "found '99999999999x10'");
}

TEST_F(BadInput, CameraThatStandsOnItsFocalPoint) {
    expectUsageFailure({"--eye", "1,2,3", "--target", "1,2,3"},
                       "inkedge: error: --camera-position: expected a place other than");
}

TEST_F(BadInput, UpAlongTheViewDirection) {
    expectUsageFailure({"--camera-direction", "-0,-2,0", "--camera-view-up", "0,1,0"},
                       "--camera-view-up: expected a direction across the view direction 0,-1,0, found one along it");
    expectUsageFailure({"--camera-view-up", "0,0,0"}, "--camera-view-up: expected a direction, found 0,0,0");
    expectUsageFailure({"--up", "0,0,0"}, "--up: expected an axis, as in +Z, or a direction other than 0,0,0, found");
}

TEST_F(BadInput, DirectionOfNoLength) { expectUsageFailure({"--camera-direction", "0,0,0"}, "camera-direction: "); }

TEST_F(BadInput, ViewAngleOutOfRange) {
    for (const char* angle : {"0", "180", "-10", "360", "nan", "inf"}) {
        expectUsageFailure({"--fov", angle}, "--camera-view-angle: expected ");
    }
}

TEST_F(BadInput, ViewsThatNestDeeply) {
    constexpr std::size_t deep = 300'000;  // more than a stack holds of calls
    for (const std::string& before :
         {std::string{}, std::string{"[{\"name\":"}, std::string{"[{\"camera-position\":"}}) {
        const std::string views =
            file("views.json", before + std::string(deep, '[') + std::string(deep, ']') + (before.empty() ? "" : "}]"));
        expectFailure(run({"render", roof(), "-o", "{view}.png", "--views", views}), 2,
                      HasSubstr(views + ": expected a JSON list of views, found lists or objects over 4 deep"));
    }
    const std::string views = file("views.json", "[{\"name\": \"" + std::string(100'000, '?') + "\"}]");
    const Outcome outcome = run({"render", roof(), "-o", "{view}.png", "--views", views});
    expectFailure(outcome, 2, HasSubstr("name: expected letters, digits, -, _ and ., found \""));
    EXPECT_LT(outcome.error.size(), 500U);
}

TEST_F(BadInput, CamerasBeyondWhatCanBeDrawn) {
    for (const std::string from : {"image", "object"}) {
        for (const Arguments& camera :
             {Arguments{"--eye", "1e30,0,0"}, Arguments{"--eye", "0,1e9,1"}, Arguments{"--eye", "1e300,0,0"},
              Arguments{"--target", "1e30,0,0"}, Arguments{"--fov", "1e-300"}, Arguments{"--fov", "179.9999999999"},
              Arguments{"--zoom", "1e300"}, Arguments{"--zoom", "1e-300"}, Arguments{"--azimuth", "1e300"},
              Arguments{"--camera-orthographic", "1e-300"}, Arguments{"--camera-orthographic", "1e-30"},
              Arguments{"--camera-orthographic", "1e300"}, Arguments{"--camera-direction", "1e300,1e300,0"},
              Arguments{"--up", "1e300,1,0"}, Arguments{"--dpi", "1e300"}, Arguments{"--line-width", "1e300mm"}}) {
            Arguments flags{"--lines-from", from, "-q"};
            flags.insert(flags.end(), camera.begin(), camera.end());
            expectUsageFailure(flags, ": expected ");
        }
    }
}

TEST_F(BadInput, TwoWaysToSayOneThing) {
    expectUsageFailure({"--eye", "1,2,3", "--azimuth", "10"}, "--camera-position: expected it without");
    expectUsageFailure({"--camera-index", "0", "--camera-view-up", "0,0,1"}, "--camera-index: expected it without");
}

TEST_F(BadInput, CameraThatTheFileDoesNotHave) {
    expectUsageFailure({"--camera-index", "1"}, "camera-index: expected a camera of the file, ");
}

TEST_F(BadInput, DeviceThatIsNotThere) {
    if (!works("egl")) GTEST_SKIP() << "egl does not work here";
    expectUsageFailure({"--device", "999"}, "--device: expected an EGL device that `inkedge doctor` lists, found 999");
    expectUsageFailure({"--device", "0", "--backend", "osmesa"}, "--device: expected it with the egl backend only");
}

TEST_F(BadInput, BrushThatIsNone) {
    const auto draw = [&](const std::string& brush, const std::string& output) {
        return run({"render", roof(), "-o", output, "--size", "8x8", "--lines-from", "object", "--brush", brush});
    };
    expectFailure(draw("missing.png", "picture.png"), 3, HasSubstr("missing.png: expected a file, found none"));
    const std::string text = file("brush.png", "hello there\n");
    expectFailure(draw(text, "picture.png"), 3, HasSubstr(text + ": expected a PNG picture, found other text"));
    for (const std::string output : {"lines.svg", "lines.SVG", "lines.pdf", "lines.dxf"})
        expectFailure(draw(text, output), 2,
                      AnyOf(HasSubstr("brush: expected a picture"), HasSubstr("--brush: expected a picture")));
}

TEST_F(BadInput, WhatMarksPixelsForAFileOfLines) {
    for (const std::string output : {"lines.svg", "lines.pdf", "lines.dxf", "lines.json"}) {
        expectFailure(run({"render", roof(), "-o", output, "--style", "sumi"}), 2,
                      HasSubstr("--style: expected a picture as --output, found " + output));
        expectFailure(run({"render", roof(), "-o", output, "--function", "height"}), 2,
                      HasSubstr("--function: expected a picture as --output, found " + output));
    }
}

TEST_F(BadInput, OutputOfAnUnknownKind) {
    for (const std::string name : {"picture.jpg", "picture.dwg", "picture", "picture.png.gz"}) {
        expectFailure(
            run({"render", roof(), "-o", name}), 2,
            HasSubstr(name + ": expected a name that ends in .png, .tif, .tiff, .exr or .npz, or for lines in .svg, "
                             ".pdf, .dxf or .json, found "));
    }
}

TEST_F(BadInput, FieldOfAnOutputThatIsNone) {
    expectFailure(run({"render", roof(), "-o", "{modle}.png"}), 2,
                  HasSubstr("{modle}.png: expected {model}, {view} or {map} to be filled in, found {modle}"));
    expectFailure(run({"render", roof(), "-o", "a.png", "--metadata", "{viwe}.json"}), 2, HasSubstr("found {viwe}"));
}

TEST_F(BadInput, FlagWithASlip) {
    expectFailure(run({"render", roof(), "-o", "a.png", "--hiden", "dashed"}), 2, HasSubstr("is it --hidden? see"));
    expectFailure(run({"render", roof(), "-o", "a.png", "--linewidth=2"}), 2, HasSubstr("is it --line-width? see"));
    expectFailure(run({"render", roof(), "-o", "a.png", "--xyzzyx"}), 2, HasSubstr("found '--xyzzyx'; see"));
}

TEST_F(BadInput, ChoiceThatAFormatDoesNotHave) {
    const std::string model = file("a.stl",
                                   "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                   "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
    expectFailure(run({"render", model, "-o", "a.png", "--animation", "walk"}), 2,
                  HasSubstr("--animation: expected an animation of the file, found 'walk' for STL, which has none"));
    expectFailure(run({"render", model, "-o", "a.png", "--scene", "4"}), 2,
                  HasSubstr("--scene: expected a scene of the file, found '4' for STL, which has none"));
    expectFailure(run({"render", model, "-o", "a.png", "--camera-index", "3"}), 2,
                  HasSubstr("--camera-index: expected a camera of the file, found 3 for one that has none"));
}

TEST_F(BadInput, PictureWhoseHeaderAsksForTooMuch) {
    const std::string huge = file("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n");
    expectFailure(run({"compare", huge, huge}), 3,
                  HasSubstr("a.hdr: cannot be read as a picture: expected at most 1073741824 values, width x height x "
                            "channels, found 60000 x 60000 x 3"));
}

TEST_F(BadInput, LevelOverOneForPicturesOfWholeNumbers) {
    const std::string picture = INKEDGE_SOURCE_DIR "/reference_images/readme_gear.png";
    expectSuccess(run({"compare", picture, picture, "--level", "1"}));
    expectFailure(run({"compare", picture, picture, "--level", "5"}), 2,
                  HasSubstr("--level: expected 0 to 1 (1 is white over black), found 5"));
}

TEST_F(BadInput, OutputInAFolderThatIsMissing) {
    expectFailure(run({"render", roof(), "-o", "missing/picture.png"}), 5,
                  HasSubstr("missing/picture.png: cannot be written: expected a folder missing, found none"));
}

TEST_F(BadInput, OutputBelowARegularFile) {
    const std::string output = roof() + "/picture.png";
    expectFailure(run({"render", roof(), "-o", output}), 5, HasSubstr(output + ": cannot be written: expected "));
}

TEST_F(BadInput, OutputThatIsAFolder) {
    const std::filesystem::path output = models_ / "folder.png";
    std::filesystem::create_directory(output);
    expectFailure(run({"render", roof(), "-o", output, "--size", "8x8"}), 5, HasSubstr("found a folder"));
}

TEST_F(BadInput, OutputToADeviceThatIsFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const std::filesystem::path output = models_ / "full.png";
    std::filesystem::create_symlink("/dev/full", output);
    expectFailure(run({"render", roof(), "-o", output, "--size", "8x8"}), 5, HasSubstr("expected room for the file"));
}

TEST_F(BadInput, MetadataThatCannotBeWrittenKeepsThePictureFromAppearing) {
    expectFailure(run({"render", roof(), "-o", "picture.png", "--metadata", "missing/metadata.json"}), 5,
                  HasSubstr("missing/metadata.json: cannot be written: "));
}

TEST_F(BadInput, MapThatCannotBeWrittenKeepsThePictureFromAppearing) {
    std::filesystem::create_directory(models_ / "picture.depth.png");
    const std::string output = models_ / "picture.png";
    expectFailure(run({"render", roof(), "-o", output, "--maps", "depth", "--size", "8x8"}), 5,
                  HasSubstr("picture.depth.png: "));
    EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(BadInput, NoBackendThatWorks) {
    expectFailure(render(roof(), {}, withoutBackends()), 4,
                  testing::AllOf(HasSubstr("expected a context for offscreen OpenGL 4.5, found none"), HasSubstr("egl"),
                                 HasSubstr("osmesa"), HasSubstr("install")));
}

TEST_F(BadInput, CommandLinesThatAreNone) {
    const std::string usage = "; see inkedge render --help\n";
    const auto expectRefusal = [&](const Arguments& arguments, const std::string& text) {
        expectFailure(run(arguments), 2, HasSubstr(text));
    };
    expectRefusal({},
                  "expected render, batch, gallery, sheet, tune, compare, inspect, doctor, completion or manual, found "
                  "nothing; see inkedge --help");
    expectRefusal({"draw", "a.glb"}, "completion or manual, found 'draw'; see inkedge --help");
    expectRefusal({"render"}, "expected MODEL, found none" + usage);
    expectRefusal({"render", roof()}, "expected --output, found none" + usage);
    expectRefusal({"render", roof(), "-o"}, "--output: expected one value, found none" + usage);
    expectRefusal({"render", roof(), "-o", "a.png", "--colour", "red"}, "found '--colour'" + usage);
    expectRefusal({"render", roof(), "other.glb", "-o", "a.png"},
                  "found it asked for by view 0 of other.glb too; put {model}");
    expectRefusal({"inspect", roof(), "other.glb"}, "found 'other.glb'; see inkedge inspect --help\n");
    expectRefusal({"render", roof(), "-o", "a.png", "-o", "b.png"},
                  "--output: expected one value, found several" + usage);
    expectRefusal({"compare", "a.png"}, "expected B, found none; see inkedge compare --help\n");
    expectRefusal({"compare", "a.png", "b.png", "--level", "-1"}, "--level: expected a number from 0, found '-1'");
    expectRefusal({"compare", "a.png", "b.png", "--share", "2"}, "--share: expected a number from 0 to 1, found '2'");
    expectRefusal({"compare", "a.png", "b.png", "--hard-limit", "x"},
                  "--hard-limit: expected a number from 0, found 'x'");
    expectRefusal({"doctor", "--verbose"}, "found '--verbose'; see inkedge doctor --help\n");
}

TEST_F(BadInput, PicturesThatCannotBeCompared) {
    const std::string model = roof();
    expectFailure(run({"compare", "missing.png", model}), 3, HasSubstr("missing.png: cannot be read as a picture: "));
    const std::string small = models_ / "small.png";
    const std::string large = models_ / "large.png";
    expectSuccess(run({"render", model, "-o", small, "--size", "8x8"}));
    expectSuccess(run({"render", model, "-o", large, "--size", "9x8"}));
    expectFailure(run({"compare", small, model}), 3, HasSubstr(model + ": cannot be read as a picture: "));
    const std::string cut = file("cut.png", contents(large).substr(0, 60));
    expectFailure(run({"compare", small, cut}), 3, HasSubstr(cut + ": cannot be read as a picture: "));
    expectFailure(run({"compare", small, large}), 3, HasSubstr("8 x 8 pixels"));
    expectFailure(run({"compare", small, small, "-o", "missing/difference.png"}), 5, HasSubstr("difference.png"));
    expectFailure(run({"compare", small, small, "-o", "difference.gif"}), 2, HasSubstr("difference.gif"));
}

}  // namespace
