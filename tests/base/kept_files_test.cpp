#include "base/kept_files.h"

#include <chrono>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "base/temporary_folder.h"

namespace inkedge::base {
namespace {

struct KeptFilesOf : testing::Test {
    std::string read() {
        return kept.of(file, [&] {
            ++times;
            return contents(file);
        });
    }
    TemporaryFolder folder;
    std::filesystem::path file = folder / "file";
    KeptFiles<std::string> kept;
    int times = 0;
};

TEST_F(KeptFilesOf, anUnchangedFileAreReadOnce) {
    put(file, "one");
    EXPECT_EQ(read(), "one");
    EXPECT_EQ(read(), "one");
    EXPECT_EQ(times, 1);
}

TEST_F(KeptFilesOf, aFileOfAnotherSizeAreReadAgain) {
    put(file, "one");
    const auto time = std::filesystem::last_write_time(file);
    EXPECT_EQ(read(), "one");
    put(file, "three");
    std::filesystem::last_write_time(file, time);
    EXPECT_EQ(read(), "three");
}

TEST_F(KeptFilesOf, aFileOfAnotherTimeAreReadAgain) {
    put(file, "one");
    EXPECT_EQ(read(), "one");
    put(file, "two");
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) - std::chrono::hours{1});
    EXPECT_EQ(read(), "two") << "an older file may take its place";
}

TEST_F(KeptFilesOf, aFileThatCannotBeReadAreAskedForAgain) {
    const auto fail = []() -> std::string { throw std::runtime_error{"no file"}; };
    EXPECT_THROW((void)kept.of(file, fail), std::runtime_error);
    put(file, "one");
    EXPECT_EQ(read(), "one");
    std::filesystem::remove(file);
    EXPECT_THROW((void)kept.of(file, fail), std::runtime_error);
}

}  // namespace
}  // namespace inkedge::base
