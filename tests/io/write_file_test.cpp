#include <inkedge/write_file.h>

#include <array>
#include <cstring>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <inkedge/write.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "io/decoded_files.h"

namespace {

namespace fs = std::filesystem;
using namespace inkedge::decoded_files;
using namespace inkedge;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(WriteFile, replacesAFileAndLeavesNothingElse) {
    const TemporaryFolder folder;
    put(folder / "a", "a longer text");
    writeFile(folder / "a", bytesOf("new"));
    EXPECT_EQ(contents(folder / "a"), "new");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(WriteFile, givesTheModeThatTheUserAskedFor) {
    const TemporaryFolder folder;
    const mode_t old = ::umask(027);
    writeFile(folder / "a", bytesOf("new"));
    ::umask(old);
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms{0640});
}

TEST(WriteFile, writesWhereALinkPoints) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "real");
    put(folder / "real/file", "old");
    fs::create_symlink("real/file", folder / "link");
    writeFile(folder / "link", bytesOf("new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(contents(folder / "real/file"), "new");
}

TEST(WriteFile, writesIntoAPipeInsteadOfReplacingIt) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    writeFile(folder / "pipe", bytesOf("new"));
    std::array<char, 8> buffer{};
    EXPECT_EQ(::read(reader, buffer.data(), buffer.size()), 3);
    EXPECT_STREQ(buffer.data(), "new");
    ::close(reader);
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(WriteFile, saysWhichFolderIsMissing) {
    const TemporaryFolder folder;
    const std::string target = (folder / "none/a").string();
    const std::string expected = target + ": cannot be written: expected a folder " + (folder / "none").string() +
                                 ", found none; create it first";
    expectError(Error::Kind::Output, testing::StrEq(expected), [&] { writeFile(target, bytesOf("new")); });
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WriteFile, refusesAPathBelowAFile) {
    const TemporaryFolder folder;
    put(folder / "file", "old");
    expectError(Error::Kind::Output, HasSubstr("to be a folder, found a file in its way"),
                [&] { writeFile(folder / "file/a", bytesOf("new")); });
    EXPECT_EQ(contents(folder / "file"), "old");
}

TEST(WriteFile, refusesAFoldersName) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a");
    expectError(Error::Kind::Output, HasSubstr("expected a file, found a folder"),
                [&] { writeFile(folder / "a", bytesOf("new")); });
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(WriteFile, saysThatADeviceIsFull) {
    expectError(Error::Kind::Output, StartsWith("/dev/full: cannot be written: expected room for the file, found: "),
                [] { writeFile("/dev/full", bytesOf("new")); });
}

TEST(WriteFile, keepsTheOldFileWhenTheNewOneFails) {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    {
        const FileSizeLimit limit{2};
        expectError(Error::Kind::Output, HasSubstr("cannot be written"),
                    [&] { writeFile(folder / "a", bytesOf("new")); });
    }
    EXPECT_EQ(contents(folder / "a"), "old");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

}  // namespace
