// The command as a whole: help, version, and the verbs compare and doctor.
#include "cli/command.h"

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Help : public Command {};

TEST_F(Help, NamesEveryVerb) {
    for (const char* flag : {"--help", "-h"}) {
        const Outcome outcome = run({flag});
        expectSuccess(outcome);
        EXPECT_EQ(outcome.error, "");
        for (const char* verb : {"render", "compare", "doctor"}) EXPECT_THAT(outcome.out, HasSubstr(verb));
    }
}

TEST_F(Help, OfEachVerbNamesItsFlags) {
    const auto expectFlags = [&](const std::string& verb, const std::vector<std::string>& flags) {
        const Outcome outcome = run({verb, "--help"});
        expectSuccess(outcome);
        for (const std::string& flag : flags) EXPECT_THAT(outcome.out, HasSubstr(flag)) << verb;
    };
    expectFlags("render", {"MODEL", "-o,--output", "--metadata", "--json", "-q,--quiet", "-v,--verbose", "--preset",
                           "--config", "--print-config"});
    expectFlags("compare", {"A", "B", "-o,--output", "--level", "--share", "--hard-limit", "--json", "-q,--quiet",
                            "--lines", "--distance", "--speck", "--view"});
    expectFlags("doctor", {"--json"});
}

TEST_F(Help, VersionIsOneLine) {
    const Outcome outcome = run({"--version"});
    expectSuccess(outcome);
    EXPECT_THAT(outcome.out, testing::MatchesRegex("inkedge [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

class Compare : public Command {
protected:
    // Two pictures of the same lines on white: black ones, and ones of level 51 = 0.2.
    void SetUp() override {
        for (const auto& [name, color] : {std::pair{"a.png", "#000000"}, std::pair{"b.png", "#333333"}}) {
            expectSuccess(
                run({"render", roof(), "-o", name, "--size", "40x40", "--detector", "classic", "--line-color", color}));
        }
    }
    json compared(Arguments flags) const {
        flags.insert(flags.begin(), {"compare", "a.png", "b.png", "--json"});
        return json::parse(run(flags).out);
    }
};

TEST_F(Compare, SamePicturesAreSame) {
    const Outcome outcome = run({"compare", "a.png", "a.png"});
    expectSuccess(outcome);
    EXPECT_THAT(outcome.out, StartsWith("same: 0 of 1600 pixels"));
}

TEST_F(Compare, DifferentPicturesExitWithOne) {
    const Outcome outcome = run({"compare", "a.png", "b.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, StartsWith("different: "));
    EXPECT_EQ(outcome.error, "");
}

TEST_F(Compare, JsonHoldsCountsAndMaxima) {
    const json comparison = compared({});
    EXPECT_EQ(comparison["same"], false);
    EXPECT_EQ(comparison["width"], 40);
    EXPECT_EQ(comparison["height"], 40);
    EXPECT_EQ(comparison["channels"], 1);
    EXPECT_GT(comparison["pixels_over_level"].get<int>(), 20);
    EXPECT_DOUBLE_EQ(comparison["share_over_level"].get<double>(),
                     comparison["pixels_over_level"].get<double>() / 1600.0);
    EXPECT_NEAR(comparison["maximum"].get<double>(), 0.2, 1e-6);
    EXPECT_EQ(comparison["maximum_at"].size(), 2U);
    EXPECT_NEAR(comparison["mean"].get<double>(), 0.2 * comparison["share_over_level"].get<double>(), 1e-6);
}

TEST_F(Compare, DifferencesUpToTheLevelDoNotCount) {
    EXPECT_EQ(compared({"--level", "0.2"})["same"], true);
    EXPECT_EQ(compared({"--level", "0.19"})["same"], false);
}

TEST_F(Compare, AShareOfPixelsMayLieOverTheLevel) {
    const double share = compared({})["share_over_level"].get<double>();
    EXPECT_EQ(compared({"--share", std::to_string(share + 1e-5)})["same"], true);
    EXPECT_EQ(compared({"--share", std::to_string(share - 1e-5)})["same"], false);
}

TEST_F(Compare, NoPixelMayLieOverTheHardLimit) {
    EXPECT_EQ(compared({"--share", "1", "--hard-limit", "0.2"})["same"], true);
    EXPECT_EQ(compared({"--share", "1", "--hard-limit", "0.19"})["same"], false);
}

TEST_F(Compare, WritesAPictureOfTheDifferences) {
    EXPECT_EQ(run({"compare", "a.png", "b.png", "-o", "difference.png"}).exitCode, 1);
    EXPECT_THAT(folder_.names(), ElementsAre("a.png", "b.png", "difference.png"));
    // White lines on black: a.png the other way round, so every pixel differs by all there is.
    const json inverse = json::parse(run({"compare", "a.png", "difference.png", "--json"}).out);
    EXPECT_EQ(inverse["pixels_over_level"], 1600);
    EXPECT_EQ(inverse["mean"], 1.0);
}

TEST_F(Compare, QuietOnlyHasAnExitCode) {
    for (const char* flag : {"-q", "--quiet"}) {
        const Outcome outcome = run({"compare", "a.png", "b.png", flag});
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_EQ(outcome.out + outcome.error, "");
    }
}

class Doctor : public Command {};

TEST_F(Doctor, ListsEveryBackendAndWhichOneAutoTakes) {
    const Outcome outcome = run({"doctor"});
    expectSuccess(outcome);
    EXPECT_THAT(outcome.out, HasSubstr("egl ("));
    EXPECT_THAT(outcome.out, HasSubstr("osmesa ("));
    EXPECT_THAT(outcome.out, HasSubstr("--backend auto draws with "));
}

TEST_F(Doctor, JsonHoldsTheStringsOfWhatWorksAndTheReasonOfWhatFails) {
    const Outcome outcome = run({"doctor", "--json"});
    expectSuccess(outcome);
    const json backends = json::parse(outcome.out)["backends"];
    ASSERT_GE(backends.size(), 2U);
    for (const json& backend : backends) {
        const bool works = backend["works"];
        EXPECT_EQ(backend["failure"].get<std::string>().empty(), works);
        for (const char* text : {"vendor", "renderer", "version"}) {
            EXPECT_EQ(backend[text].get<std::string>().empty(), !works) << text;
        }
        EXPECT_TRUE(backend["software"].is_boolean());
        EXPECT_FALSE(backend["platform"].get<std::string>().empty());
    }
}

TEST_F(Doctor, SaysTheReasonAndTheRemedyWhereNothingWorks) {
    const Outcome text = run({"doctor"}, withoutBackends());
    EXPECT_EQ(text.exitCode, 4);
    EXPECT_THAT(text.out, HasSubstr("No backend works"));
    EXPECT_THAT(text.out, HasSubstr("install Mesa"));
    const Outcome outcome = run({"doctor", "--json"}, withoutBackends());
    EXPECT_EQ(outcome.exitCode, 4);
    const json found = json::parse(outcome.out);
    for (const json& backend : found.at("backends")) {
        EXPECT_EQ(backend["works"], false);
        EXPECT_THAT(backend["failure"].get<std::string>(), HasSubstr("expected "));
    }
}

}  // namespace
