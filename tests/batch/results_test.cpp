// The file of results: whole lines, one an item in the end, whoever writes to it.
#include "batch/results.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "batch/batch.h"
#include "batch/earlier.h"
#include "batch/pace.h"
#include "batch/result.h"

namespace inkedge::batch {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::string line(const std::string& id, State state, const std::string& key = "k") {
    return lineOf(Result{.id = id, .state = state, .key = key, .error = state == State::Drawn ? "" : "found a fault"});
}

class ResultsTest : public testing::Test {
protected:
    std::vector<std::string> lines() const {
        std::vector<std::string> all;
        Results{file_}.read([&](std::string_view each) {
            const auto result = earlierResult(each);
            all.push_back(result ? fmt::format("{} {}", result->id, stateNames[static_cast<std::size_t>(result->state)])
                                 : "none");
        });
        return all;
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "results.jsonl";
};

TEST_F(ResultsTest, haveALineAnItem) {
    Results results{file_};
    EXPECT_THAT(lines(), IsEmpty());
    results.append(line("a", State::Drawn));
    results.append(line("b\"\\/\u00e4", State::Refused));
    EXPECT_THAT(lines(), ElementsAre("a drawn", "b\"\\/\u00e4 refused"));
}

TEST_F(ResultsTest, endWhatWasCutShort) {
    put(file_, line("a", State::Drawn) + line("b", State::Drawn).substr(0, 20));
    Results results{file_};
    results.append(line("c", State::Drawn));
    EXPECT_THAT(lines(), ElementsAre("a drawn", "none", "c drawn"));
    results.compact();
    EXPECT_THAT(lines(), ElementsAre("a drawn", "c drawn"));
}

TEST_F(ResultsTest, keepTheLastLineOfAnIdButWhatWasDrawn) {
    Results results{file_};
    for (const auto& [id, state] : {std::pair{"a", State::Failed},
                                    {"b", State::Drawn},
                                    {"a", State::Drawn},
                                    {"b", State::Timeout},
                                    {"c", State::Failed},
                                    {"c", State::Refused},
                                    {"q\"", State::Failed},
                                    {"q\"", State::Killed},
                                    {"a", State::Failed}})
        results.append(line(id, state));
    results.compact();
    EXPECT_THAT(lines(), ElementsAre("b drawn", "a drawn", "c refused", "q\" killed"));
    results.append(line("d", State::Drawn));
    EXPECT_THAT(lines(), testing::Contains("d drawn")) << "it goes on in the compact file";
}

TEST_F(ResultsTest, areLeftAloneWhereEachIdHasOneLine) {
    Results results{file_};
    results.append(line("a", State::Drawn));
    const auto before = std::filesystem::last_write_time(file_);
    results.compact();
    EXPECT_EQ(std::filesystem::last_write_time(file_), before);
}

TEST_F(ResultsTest, takeLinesOfSeveralProcesses) {
    constexpr int processes = 4;
    constexpr int each = 200;
    for (int p = 0; p < processes; ++p) {
        if (::fork() != 0) continue;
        Results results{file_};
        for (int i = 0; i < each; ++i) {
            results.append(line(fmt::format("{}/{}", p % 2, i), State::Drawn));
            if (i % 50 == 0) results.compact();
        }
        ::_exit(0);
    }
    for (int p = 0; p < processes; ++p) ::wait(nullptr);
    Results{file_}.compact();
    std::vector<std::string> found = lines();
    std::ranges::sort(found);
    EXPECT_EQ(found.size(), 2U * each);
    EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
    EXPECT_EQ(std::ranges::count(found, "none"), 0);
}

TEST_F(ResultsTest, arePutTogetherWhilePortionsAreAtWork) {
    constexpr std::uint64_t portions = 3;
    constexpr int each = 200;
    for (std::uint64_t p = 0; p < portions; ++p) {
        if (::fork() != 0) continue;
        Results results{resultsFile(folder_.path(), {p, portions})};
        for (int i = 0; i < each; ++i) results.append(line(fmt::format("{}/{}", p, i), State::Drawn));
        ::_exit(0);
    }
    const auto portionsFiles = [&] {
        std::vector<std::filesystem::path> files = resultsFiles(folder_.path());
        std::erase(files, file_);
        return files;
    };
    for (std::uint64_t ended = 0; ended < portions;) {
        Results{file_}.compact(portionsFiles());
        while (::waitpid(-1, nullptr, WNOHANG) > 0) ++ended;
    }
    Results{file_}.compact(portionsFiles());
    EXPECT_THAT(folder_.names(), ElementsAre("results.jsonl"));
    std::vector<std::string> found = lines();
    std::ranges::sort(found);
    EXPECT_EQ(found.size(), portions * each);
    EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
}

TEST_F(ResultsTest, ofPortionsAreReadAsOne) {
    Results{resultsFile(folder_.path(), {0, 2})}.append(line("a", State::Failed));
    Results{resultsFile(folder_.path(), {1, 2})}.append(line("b", State::Drawn));
    Results{resultsFile(folder_.path(), {2, 16})}.append(line("a", State::Drawn));
    EXPECT_THAT(folder_.names(), ElementsAre("results.0-of-2.jsonl", "results.02-of-16.jsonl", "results.1-of-2.jsonl"));
    std::vector<std::string> found;
    readChosenResults(folder_.path(), [&](std::string_view each) {
        found.push_back(fmt::format("{} {}", earlierResult(each)->id, startOf(each)->drawn));
    });
    EXPECT_THAT(found, UnorderedElementsAre("a true", "b true"));
}

TEST_F(ResultsTest, cannotBeWhereNoFileCanBe) {
    expectError(Error::Kind::Output, testing::HasSubstr("cannot be written: "),
                [&] { const Results results{folder_ / "missing/results.jsonl"}; });
    std::filesystem::create_directory(file_);
    expectError(Error::Kind::Output, testing::HasSubstr("found a folder"), [&] { const Results results{file_}; });
}

TEST(EarlierTest, knowsWhatIsNotToBeDoneAgain) {
    Batch batch;
    batch.timeout = 60.0;
    batch.maxMemory = 1000;
    const auto after = [&](Result result) {
        result.id = "a";
        result.key = "k";
        Earlier earlier{batch};
        earlier.take(lineOf(result));
        return earlier.find("a", "k");
    };
    EXPECT_EQ(after({.state = State::Drawn}), State::Drawn);
    EXPECT_EQ(after({.state = State::Refused}), State::Refused);
    EXPECT_EQ(after({.state = State::Crashed}), State::Crashed);
    EXPECT_EQ(after({.state = State::Failed}), std::nullopt) << "a fault of the machine";
    EXPECT_EQ(after({.state = State::Killed}), std::nullopt);
    EXPECT_EQ(after({.state = State::Timeout, .limit = 60.0}), State::Timeout);
    EXPECT_EQ(after({.state = State::Timeout, .limit = 59.0}), std::nullopt) << "it may take longer now";
    EXPECT_EQ(after({.state = State::Memory, .limit = 2000.0}), State::Memory);
    EXPECT_EQ(after({.state = State::Memory, .limit = 999.0}), std::nullopt);
    batch.retry = true;
    EXPECT_EQ(after({.state = State::Refused}), std::nullopt);
    EXPECT_EQ(after({.state = State::Drawn}), State::Drawn);
    Earlier earlier{batch};
    earlier.take(line("a", State::Drawn, "k1"));
    EXPECT_EQ(earlier.find("a", "k2"), std::nullopt) << "the model or the settings have changed";
    earlier.take("no line");
    earlier.take(R"({"id":"b","state":"lost","key":"k"})");
    EXPECT_EQ(earlier.find("b", "k"), std::nullopt);
}

TEST(EarlierTest, looksAtTheModelsOtherFiles) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.bin";
    put(file, "hello");
    const auto find = [&] {
        const Batch batch;
        Earlier earlier{batch};
        Result result{.id = "a", .key = "k"};
        result.others = {{file, "cbd8a7b341bd9b025b1e906a48ae1d19"}};
        earlier.take(lineOf(result));
        return earlier.find("a", "k");
    };
    EXPECT_EQ(find(), State::Drawn);
    put(file, "hello!");
    EXPECT_EQ(find(), std::nullopt);
}

TEST(Pace, isThatOfLate) {
    Pace pace;
    EXPECT_EQ(pace.rate(), 0.0);
    EXPECT_EQ(pace.left(10), std::nullopt);
    for (int i = 0; i <= 100; ++i) pace.add(i, 1000U * static_cast<unsigned>(i));  // quickly, as what was done before
    for (int i = 1; i <= 1000; ++i) pace.add(100.0 + 0.2 * i, 100'000U + static_cast<unsigned>(i));
    EXPECT_NEAR(pace.rate(), 5.0, 0.1);
    EXPECT_NEAR(pace.left(100).value(), 20.0, 0.5);
}

}  // namespace
}  // namespace inkedge::batch
