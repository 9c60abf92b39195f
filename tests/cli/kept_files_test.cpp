// No output replaces what is read, or another output; links stay; messages are one line whatever stands in a name.
#include "cli/command.h"

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class KeptFiles : public Command {
protected:
    /// A model in the folder that the command runs in, and what is in it.
    std::string ownModel(const std::string& name = "roof.gltf") const {
        fs::copy(fs::path{roof()}.replace_extension(".bin"), folder_ / "roof.bin",
                 fs::copy_options::overwrite_existing);
        fs::copy(roof(), folder_ / name);
        return name;
    }
    void expectRefused(const Arguments& arguments, const std::string& one, const std::string& other) const {
        const auto before = contentsOfAll();
        expectFailure(run(arguments), 2, AllOf(HasSubstr(one), HasSubstr(other)));
        EXPECT_EQ(contentsOfAll(), before);
    }
    std::map<std::string, std::string> contentsOfAll() const {
        std::map<std::string, std::string> all;
        for (const std::string& name : folder_.names()) all[name] = contents(folder_ / name);
        return all;
    }
};

TEST_F(KeptFiles, ModelIsNoOutput) {
    const std::string model = ownModel();
    const std::string why = ": expected an output other than what is read, found the model roof.gltf; choose another";
    expectRefused({"render", model, "-o", "a.png", "--metadata", model}, "roof.gltf" + why, "");
    expectRefused(
        {"render", model, "-o", "a.png", "--metadata", "./../" + folder_.path().filename().string() + "/" + model}, why,
        "../");
    fs::create_symlink(model, folder_ / "link.png");
    expectRefused({"render", model, "-o", "link.png"}, "link.png" + why, "");
    fs::create_hard_link(folder_ / model, folder_ / "hard.exr");
    expectRefused({"render", model, "-o", "hard.exr"}, "hard.exr" + why, "");
    fs::create_symlink(model, folder_ / "a.depth.png");
    expectRefused({"render", model, "-o", "a.png", "--maps", "depth"}, "a.depth.png" + why, "");
}

TEST_F(KeptFiles, FilesThatAModelNamesAreNoOutputs) {
    const std::string model = ownModel();
    expectRefused({"render", model, "-o", "a.png", "--metadata", "roof.bin"},
                  "roof.bin: expected an output other than what is read, found a file of roof.gltf, ",
                  "roof.bin; choose");
    std::string text = contents(folder_ / model);
    text.insert(1, R"("images":[{"uri":"skin.png"}],)");
    put(folder_ / model, text);
    put(folder_ / "skin.png", "a picture that no setting reads");
    expectRefused({"render", model, "-o", "skin.png"}, "skin.png: expected an output other than what is read", model);
}

TEST_F(KeptFiles, OtherInputsAreNoOutputs) {
    const std::string model = ownModel();
    put(folder_ / "own.conf", "size = 16x16\n");
    put(folder_ / "views.json", R"([{"name": "a"}])");
    put(folder_ / "shade.glsl", "float value(Surface s) { return 1.0; }\n");
    const auto refuse = [&](const Arguments& more, const std::string& metadata) {
        Arguments arguments{"render", model, "-o", "{view}.png", "--metadata", metadata};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectRefused(arguments, metadata + ": expected an output other than what is read, found ", metadata + ";");
    };
    refuse({"--config", "own.conf"}, "own.conf");
    refuse({"--views", "views.json"}, "views.json");
    refuse({"--function", "custom:shade.glsl"}, "shade.glsl");
    expectSuccess(run({"render", model, "-o", "brush.png", "--size", "8x8"}));
    expectRefused({"render", model, "-o", "brush.png", "--lines-from", "object", "--brush", "brush.png"},
                  "found --brush brush.png", "brush.png: ");
}

TEST_F(KeptFiles, OutputsAreFilesOfTheirOwn) {
    const std::string model = ownModel();
    expectRefused({"render", model, "-o", "a.json", "--metadata", "./a.json"},
                  "./a.json: expected a file for --output a.json alone, found it asked for by --metadata too", "");
    expectRefused({"render", model, "-o", "a.png", "--maps", "depth", "--metadata", "a.depth.png"},
                  "a.depth.png: expected a file for --output a.depth.png alone", "");
    put(folder_ / "000.png", "");
    fs::create_symlink("000.png", folder_ / "001.png");
    expectRefused({"render", model, "-o", "{view}.png", "--views", "turntable:2"},
                  "001.png: expected a file for view 000 of roof.gltf alone, found it asked for by view 001 of "
                  "roof.gltf too, as 000.png; put {model} and {view} in its name",
                  "");
}

TEST_F(KeptFiles, PicturesThatAreComparedAreNoOutputs) {
    expectSuccess(run({"render", roof(), "-o", "a.png", "--size", "8x8"}));
    fs::copy(folder_ / "a.png", folder_ / "b.png");
    for (const char* output : {"a.png", "./b.png"})
        expectRefused({"compare", "a.png", "b.png", "-o", output},
                      std::string{output} + ": expected an output other than what is compared, found ", ".png; choose");
    expectSuccess(run({"compare", "a.png", "b.png", "-o", "c.png"}));
}

TEST_F(KeptFiles, BracesInAModelsNameStay) {
    const std::string model = ownModel("{view}_{map}{model}.gltf");
    expectSuccess(run({"render", model, "-o", "x{model}.{view}.png", "--maps", "depth", "--size", "8x8"}));
    expectSuccess(run({"render", model, "-o", "y{map}{model}.png", "--size", "8x8"}));
    EXPECT_THAT(folder_.names(),
                ElementsAre("roof.bin", "x{view}_{map}{model}.0.depth.png", "x{view}_{map}{model}.0.png",
                            "youtline{view}_{map}{model}.png", "{view}_{map}{model}.gltf"));
}

TEST_F(KeptFiles, ModelsNameLeadsIntoNoOtherFolder) {
    fs::create_directory(folder_ / "in");
    for (const std::string model : {"in/...gltf", "in/..gltf"}) {  // the extension is taken off a name of dots
        fs::copy(fs::path{roof()}.replace_extension(".bin"), folder_ / "in/roof.bin",
                 fs::copy_options::overwrite_existing);
        fs::copy(roof(), folder_ / model);
        const Outcome outcome = run({"render", model, "-o", "in/{model}/a.png", "--size", "8x8"});
        expectFailure(outcome, 2,
                      HasSubstr("in/{model}/a.png: expected a name for {model} that stays in the folder, "));
        EXPECT_THAT(folder_.names(), ElementsAre("in"));
    }
}

// --- links

TEST_F(KeptFiles, LinksAreFollowed) {
    fs::create_directory(folder_ / "in");
    put(folder_ / "in/a.png", "older");
    fs::create_symlink("in/a.png", folder_ / "a.png");
    fs::create_symlink("a.png", folder_ / "b.png");
    expectSuccess(run({"render", roof(), "-o", "b.png", "--size", "8x8"}));
    EXPECT_TRUE(fs::is_symlink(folder_ / "a.png"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "b.png"));
    EXPECT_THAT(contents(folder_ / "in/a.png"), testing::StartsWith("\x89PNG"));
}

TEST_F(KeptFiles, LinksToNothingAreErrors) {
    fs::create_symlink("gone.png", folder_ / "a.png");
    fs::create_symlink("c.png", folder_ / "b.png");
    fs::create_symlink("b.png", folder_ / "c.png");
    for (const Arguments& more : {Arguments{"-o", "a.png"}, Arguments{"-o", "d.png", "--metadata", "a.png"}}) {
        Arguments arguments{"render", roof(), "--size", "8x8"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectFailure(run(arguments), 5,
                      HasSubstr("a.png: cannot be written: expected a file behind the link, found none at gone.png; "));
    }
    expectFailure(run({"render", roof(), "-o", "c.png"}), 5, HasSubstr("c.png: cannot be written: expected "));
    for (const char* link : {"a.png", "b.png", "c.png"}) EXPECT_TRUE(fs::is_symlink(folder_ / link)) << link;
    EXPECT_THAT(folder_.names(), ElementsAre("a.png", "b.png", "c.png"));
}

// --- names

TEST_F(KeptFiles, MessagesAreOneLineWhateverStandsInAName) {
    const std::string odd = "a\nb\r\t\x1b[31m\x7f\xc2\x9b\xe2\x80\xa8";
    const std::string shown = R"(a\nb\r\t\x1b[31m\x7f\u009b\u2028)";
    for (const Arguments& arguments :
         {Arguments{"render", odd, "-o", "a.png"}, Arguments{"render", roof(), "-o", odd},
          Arguments{"render", roof(), "-o", odd + "/a.png"}, Arguments{"render", roof(), "-o", "a.png", "--size", odd},
          Arguments{"render", roof(), "-o", "a.png", "--config", odd},
          Arguments{"render", roof(), "-o", "a.png", "--views", odd},
          Arguments{"render", roof(), "-o", "a.png", "--jobs", odd},
          Arguments{"render", roof(), "-o", "a.png", "--preset", odd},
          Arguments{"render", roof(), "-o", "a.png", "--" + odd}, Arguments{"compare", odd, "b.png"},
          Arguments{"inspect", odd}, Arguments{odd}}) {
        const Outcome outcome = run(arguments);
        expectFailure(outcome, outcome.exitCode, HasSubstr(shown));
        EXPECT_THAT(outcome.exitCode, testing::AnyOf(2, 3, 5));
    }
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_F(KeptFiles, NamesInModelsAreOneLine) {
    std::string text = contents(roof());
    text.replace(text.find(R"("mesh":0)"), 8, R"("mesh":0,"name":"a\nb\u001b")");
    text.insert(1, R"("extensionsUsed":["X_\n_y"],"materials":[{"name":"m\n\u001b"}],)");
    put(models_ / "odd.gltf", text);
    const Outcome inspected = run({"inspect", models_ / "odd.gltf"});
    expectSuccess(inspected);
    EXPECT_THAT(inspected.out, AllOf(HasSubstr(R"(m\n\x1b)"), HasSubstr(R"(X_\n_y)")));
    EXPECT_EQ(inspected.out.find('\x1b'), std::string::npos);
    const Outcome drawn = run({"render", models_ / "odd.gltf", "-o", "a\nb.png", "--size", "8x8", "-v"});
    expectSuccess(drawn);
    EXPECT_THAT(drawn.error, AllOf(HasSubstr(R"(wrote a\nb.png)"), HasSubstr(R"(X_\n_y)")));
    EXPECT_EQ(drawn.error.find('\x1b'), std::string::npos);
}

}  // namespace
