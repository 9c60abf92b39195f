// What shells and man make of the command line's description.
#include <array>
#include <sstream>

#include <inkedge/setting_table.h>

#include "cli/command.h"

namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

std::filesystem::path program(const std::string& name) {
    for (const char* folder : {"/usr/bin", "/bin", "/usr/local/bin"})
        if (std::filesystem::exists(std::filesystem::path{folder} / name)) return std::filesystem::path{folder} / name;
    return {};
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

class Completion : public Command {
protected:
    std::filesystem::path script(const std::string& shell) const {
        const Outcome outcome = run({"completion", shell});
        expectSuccess(outcome);
        put(folder_ / shell, outcome.out);
        return folder_ / shell;
    }

    // What bash offers after these words; the last one is begun.
    std::vector<std::string> bash(const std::string& words) const {
        const std::string code = "source " + script("bash").string() + "; COMP_WORDS=(" + words +
                                 "); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _inkedge; printf '%s\\n' \"${COMPREPLY[@]}\"";
        const Outcome outcome = runCommand("/bin/bash", {"--norc", "-c", code}, folder_.path());
        EXPECT_EQ(outcome.error, "");
        std::vector<std::string> offered = linesOf(outcome.out);
        std::erase(offered, "");
        return offered;
    }

    std::vector<std::string> fish(const std::string& line) const {
        const std::string code = "source " + script("fish").string() + "; complete -C '" + line + "'";
        const Outcome outcome = runCommand(program("fish"), {"--no-config", "-c", code}, folder_.path());
        EXPECT_EQ(outcome.error, "");
        std::vector<std::string> offered = linesOf(outcome.out);
        for (std::string& each : offered) each = each.substr(0, each.find('\t'));
        return offered;
    }
};

TEST_F(Completion, OfBashOffersVerbsFlagsValuesAndFiles) {
    EXPECT_THAT(bash("inkedge in"), ElementsAre("inspect"));
    EXPECT_THAT(bash("inkedge render --kern"), ElementsAre("--kernel"));
    EXPECT_THAT(bash("inkedge render --kernel ''"), UnorderedElementsAre("sobel", "farid"));
    EXPECT_THAT(bash("inkedge render --kernel = f"), ElementsAre("farid"));
    EXPECT_THAT(bash("inkedge render --kernel ="), UnorderedElementsAre("sobel", "farid"));
    EXPECT_THAT(bash("inkedge render --maps depth,norm"), UnorderedElementsAre("depth,normal", "depth,normal-edges"));
    EXPECT_THAT(bash("inkedge render --line-width ''"), IsEmpty());
    EXPECT_THAT(bash("inkedge completion z"), ElementsAre("zsh"));
    EXPECT_THAT(bash("inkedge inspect --line-w"), IsEmpty());
    put(folder_ / "my part.stl", "");
    EXPECT_THAT(bash("inkedge render my"), ElementsAre("my part.stl"));
    EXPECT_THAT(bash("inkedge render -o my"), ElementsAre("my part.stl"));
}

TEST_F(Completion, OfFishOffersTheSame) {
    if (program("fish").empty()) GTEST_SKIP() << "NOT TESTED: expected fish, found none; apt-get install fish";
    EXPECT_THAT(fish("inkedge in"), ElementsAre("inspect"));
    EXPECT_THAT(fish("inkedge render --kern"), ElementsAre("--kernel"));
    EXPECT_THAT(fish("inkedge render --kernel "), UnorderedElementsAre("sobel", "farid"));
    EXPECT_THAT(fish("inkedge completion z"), ElementsAre("zsh"));
    put(folder_ / "my part.stl", "");
    EXPECT_THAT(fish("inkedge render my"), ElementsAre("my part.stl"));
}

TEST_F(Completion, OfZshIsAccepted) {
    if (program("zsh").empty()) GTEST_SKIP() << "NOT TESTED: expected zsh, found none; apt-get install zsh";
    const Outcome outcome = runCommand(program("zsh"), {"-f", "-n", script("zsh").string()}, folder_.path());
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.error, "");
}

TEST_F(Completion, AndTheManualHaveEverySetting) {
    for (const Arguments& arguments :
         std::vector<Arguments>{{"completion", "bash"}, {"completion", "zsh"}, {"completion", "fish"}, {"manual"}}) {
        const Outcome outcome = run(arguments);
        expectSuccess(outcome);
        std::string text = outcome.out;
        std::erase(text, '\\');
        for (const inkedge::SettingDescription& row : inkedge::settingTable())
            EXPECT_NE(text.find(row.name), std::string::npos) << arguments.back() << ": " << row.name;
    }
}

TEST_F(Completion, IsNotOfOtherShells) { expectFailure(run({"completion", "tcsh"}), 2, HasSubstr("bash")); }

TEST_F(Completion, TheManualIsWhatGroffTakesWithoutAWord) {
    if (program("groff").empty()) GTEST_SKIP() << "NOT TESTED: expected groff, found none; apt-get install groff-base";
    const Outcome manual = run({"manual"});
    expectSuccess(manual);
    put(folder_ / "inkedge.1", manual.out);
    const Outcome outcome =
        runCommand(program("groff"), {"-man", "-ww", "-Tutf8", "-P-cbou", "inkedge.1"}, folder_.path());
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("EXIT STATUS"), HasSubstr("INKEDGE_LINE_WIDTH")));
}

}  // namespace
