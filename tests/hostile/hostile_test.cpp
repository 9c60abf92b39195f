// Every file of tools/make_hostile gives a picture or one clear error, in little time and memory, and leaves no debris.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include <png.h>
#include <nlohmann/json.hpp>

#include "base/temporary_folder.h"
#include "cli/run_command.h"

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

namespace {

using testing::HasSubstr;

constexpr double longestSeconds =
    sanitized ? 50.0 : 5.0;  // of a processor: what else the machine does is not our doing
constexpr std::chrono::seconds longestWait{sanitized ? 300 : 60};
constexpr std::uint64_t maxBytes = std::uint64_t{2} << 30;  // a sanitizer keeps books of its own
const std::filesystem::path folder{INKEDGE_HOSTILE_FOLDER};

struct Case {
    std::string file;
    bool picture = false;
    std::string error;  // part of it
};

void PrintTo(const Case& hostile, std::ostream* out) { *out << hostile.file; }

std::vector<Case> makeCases() {
    std::filesystem::remove_all(folder);
    const Outcome made = runCommand("/usr/bin/env", {"python3", INKEDGE_SOURCE_DIR "/tools/make_hostile", folder}, "/");
    if (made.exitCode != 0) throw std::runtime_error{"make_hostile: " + made.error};
    std::vector<Case> cases;
    for (const auto& row : nlohmann::json::parse(contents(folder / "expected.json")))
        cases.push_back({row["file"], row["picture"], row["error"]});
    return cases;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

// Warnings, and after them no more than this many errors.
void expectLines(const std::string& text, std::size_t errors) {
    std::vector<std::string> lines = linesOf(text);
    ASSERT_GE(lines.size(), errors) << text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool last = i + errors >= lines.size();
        EXPECT_THAT(lines[i], testing::StartsWith(last ? "inkedge: error: " : "inkedge: warning: "));
        EXPECT_TRUE(std::ranges::none_of(lines[i], [](unsigned char c) { return std::iscntrl(c) != 0; })) << lines[i];
        EXPECT_LT(lines[i].size(), 1000U) << lines[i].substr(0, 1000);
    }
}

void expectPictureOf64Pixels(const std::filesystem::path& file) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&picture, file.c_str()), 0) << picture.message;
    EXPECT_EQ(picture.width, 64U);
    EXPECT_EQ(picture.height, 64U);
    picture.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(picture));
    EXPECT_NE(png_image_finish_read(&picture, nullptr, pixels.data(), 0, nullptr), 0) << picture.message;
}

class HostileFile : public testing::TestWithParam<Case> {};

TEST_P(HostileFile, GivesAPictureOrOneClearError) {
    const Case& hostile = GetParam();
    const TemporaryFolder output;
    const Outcome outcome =
        runCommand(INKEDGE_COMMAND, {"render", folder / hostile.file, "-o", output / "picture.png", "--size", "64x64"},
                   output.path(), {}, longestWait);

    EXPECT_LE(outcome.seconds, longestSeconds);
    if (!sanitized) {
        EXPECT_LE(outcome.peakBytes, maxBytes);
    }
    EXPECT_EQ(outcome.out, "");
    if (hostile.picture) {
        ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
        expectLines(outcome.error, 0);
        expectPictureOf64Pixels(output / "picture.png");
    } else {
        ASSERT_EQ(outcome.exitCode, 3) << outcome.error;
        expectLines(outcome.error, 1);
        EXPECT_THAT(linesOf(outcome.error).back(),
                    testing::AllOf(HasSubstr("expected "), HasSubstr("found"), HasSubstr(hostile.error)));
        EXPECT_THAT(output.names(), testing::IsEmpty());
    }
}

std::string testName(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.file;
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, HostileFile, testing::ValuesIn(makeCases()), testName);

// Neither do they disturb each other.
TEST(HostileFiles, AreDrawnOrRefusedAmongEachOther) {
    const TemporaryFolder output;
    std::string list;
    std::map<std::string, Case> cases;
    for (const Case& hostile : makeCases()) {
        const std::string id = std::to_string(cases.size());  // not every name of a file is one
        list += nlohmann::json{{"model", folder / hostile.file}, {"id", id}}.dump() + "\n";
        cases[id] = hostile;
    }
    put(output / "list.jsonl", list);
    const Outcome outcome = runCommand(INKEDGE_COMMAND, {"batch", "list.jsonl", "-o", "out", "--size", "64x64", "-q"},
                                       output.path(), {}, std::chrono::seconds{sanitized ? 1800 : 300});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
    for (const std::string& line : linesOf(contents(output / "out/results.jsonl"))) {
        const auto result = nlohmann::json::parse(line);
        const auto found = cases.extract(result["id"].get<std::string>());
        ASSERT_FALSE(found.empty()) << line;
        EXPECT_EQ(result["state"], found.mapped().picture ? "drawn" : "refused") << line;
        if (found.mapped().picture)
            expectPictureOf64Pixels(output / "out" / result["files"][0].get<std::string>());
        else
            EXPECT_THAT(result["error"].get<std::string>(), HasSubstr(found.mapped().error));
    }
    EXPECT_TRUE(cases.empty()) << "without a result: " << cases.begin()->second.file;
}

TEST(HostileFileName, ThatIsNoTextGivesAPicture) {
    const TemporaryFolder output;
    const std::filesystem::path model = output / "\xff\xfe.glb";
    std::filesystem::copy_file(INKEDGE_SOURCE_DIR "/assets/cube.glb", model);
    const Outcome outcome = runCommand(
        INKEDGE_COMMAND,
        {"render", model, "-o", "picture.png", "--json", "--metadata", "about.json", "--size", "64x64"}, output.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
}

}  // namespace
