// Files appear whole or not at all, whatever ends the write. The table of faults is in tests/README.md.
#include "base/staged_files.h"
#include "base/temporary_name.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <functional>

#include <gmock/gmock.h>

#include <inkedge/write.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"

using namespace inkedge;
using base::StagedFiles;
using base::Staging;
using testing::AnyOf;
using testing::ElementsAre;
using testing::Eq;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

const std::string older(200'000, 'o');
const std::string newer(300'000, 'n');

class StagedFilesTest : public testing::TestWithParam<Staging> {
protected:
    TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Stagings, StagedFilesTest, testing::Values(Staging::Unnamed, Staging::Named),
                         [](const auto& instance) { return instance.param == Staging::Named ? "named" : "unnamed"; });

bool hasUnnamedFiles(const TemporaryFolder& folder) {
    const int file = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (file >= 0) ::close(file);
    return file >= 0;
}

TEST_P(StagedFilesTest, appearOnlyWhenCommitted) {
    put(folder_ / "b", older);
    StagedFiles staged{GetParam()};
    staged.add(folder_ / "a", bytesOf(newer));
    staged.add(folder_ / "b", bytesOf(newer));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a"));
    EXPECT_EQ(contents(folder_ / "b"), older);
    staged.commit();
    EXPECT_THAT(folder_.names(), ElementsAre("a", "b"));
    EXPECT_EQ(contents(folder_ / "a"), newer);
    EXPECT_EQ(contents(folder_ / "b"), newer);
}

TEST_P(StagedFilesTest, leaveNothingWhenNotCommitted) {
    {
        StagedFiles staged{GetParam()};
        staged.add(folder_ / "a", bytesOf(newer));
        staged.add(folder_ / "b", bytesOf(newer));
    }
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_P(StagedFilesTest, sayThatTheirFolderIsGone) {
    std::filesystem::create_directory(folder_ / "gone");
    StagedFiles staged{GetParam()};
    staged.add(folder_ / "gone/a", bytesOf(newer));
    std::filesystem::remove_all(folder_ / "gone");
    expectError(Error::Kind::Output,
                testing::StrEq((folder_ / "gone/a").string() + ": cannot be written: expected a folder " +
                               (folder_ / "gone").string() + ", found none; create it first"),
                [&] { staged.commit(); });
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_P(StagedFilesTest, haveTheModeThatTheUserAskedFor) {
    const mode_t before = ::umask(027);
    StagedFiles staged{GetParam()};
    staged.add(folder_ / "a", bytesOf(newer));
    staged.commit();
    ::umask(before);
    EXPECT_EQ(std::filesystem::status(folder_ / "a").permissions(), static_cast<std::filesystem::perms>(0640));
}

TEST(UnnamedFiles, areSeenByNobody) {
    const TemporaryFolder folder;
    if (!hasUnnamedFiles(folder)) GTEST_SKIP() << "no files without a name in " << folder.path() << " here";
    StagedFiles staged;
    staged.add(folder / "a", bytesOf(newer));
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(NamedFiles, areRemovedByASignalHandler) {
    const TemporaryFolder folder;
    StagedFiles staged{Staging::Named};
    staged.add(folder / "a", bytesOf(newer));
    EXPECT_THAT(folder.names(), ElementsAre(testing::MatchesRegex("\\.inkedge-[0-9a-f]{16}\\.tmp")));
    base::removeTemporaryFiles();
    EXPECT_THAT(folder.names(), IsEmpty());
    expectError(Error::Kind::Output, HasSubstr("a: cannot be written: expected "), [&] { staged.commit(); });
}

/// Writes a and b in a folder again and again, until it is ended by a signal.
[[noreturn]] void writeForEver(const TemporaryFolder& folder, Staging staging, int ready) {
    ::signal(SIGTERM, [](int) {
        base::removeTemporaryFiles();
        ::_exit(128 + SIGTERM);
    });
    const std::vector<std::uint8_t> bytes = bytesOf(newer);
    for (bool first = true;; first = false) {
        if (first) (void)!::write(ready, "r", 1);
        StagedFiles staged{staging};
        staged.add(folder / "a", bytes);
        staged.add(folder / "b", bytes);
        staged.commit();
    }
}

/// Ends such a writer with this signal after a while; `check` looks at what it left.
void interruptOften(Staging staging, int signal, const std::function<void(const TemporaryFolder&)>& check) {
    for (int i = 0; i < 60; ++i) {
        const TemporaryFolder folder;
        if (i % 2 == 0) put(folder / "a", older);
        std::array<int, 2> ready{};
        ASSERT_EQ(::pipe(ready.data()), 0);
        const pid_t writer = ::fork();
        if (writer == 0) writeForEver(folder, staging, ready[1]);
        char byte = 0;
        EXPECT_EQ(::read(ready[0], &byte, 1), 1);
        ::usleep(static_cast<useconds_t>(37 * i));
        ::kill(writer, signal);
        int status = 0;
        EXPECT_EQ(::waitpid(writer, &status, 0), writer);
        EXPECT_TRUE(signal == SIGKILL ? WIFSIGNALED(status) : WEXITSTATUS(status) == 128 + SIGTERM) << status;
        for (const int end : ready) ::close(end);
        check(folder);
        if (testing::Test::HasFailure()) return;
    }
}

void expectWhole(const TemporaryFolder& folder, const std::string& name) {
    EXPECT_TRUE(contents(folder / name) == newer || (name == "a" && contents(folder / name) == older))
        << name << " has " << contents(folder / name).size() << " bytes";
}

TEST_P(StagedFilesTest, areWholeOrNotThereAfterASignal) {
    interruptOften(GetParam(), SIGTERM, [](const TemporaryFolder& folder) {
        for (const std::string& name : folder.names()) {
            EXPECT_THAT(name, AnyOf(Eq("a"), Eq("b")));
            expectWhole(folder, name);
        }
    });
}

TEST_P(StagedFilesTest, areWholeUnderTheirNamesAfterAKill) {
    interruptOften(GetParam(), SIGKILL, [&](const TemporaryFolder& folder) {
        const bool unnamed = GetParam() == Staging::Unnamed && hasUnnamedFiles(folder);
        for (const std::string& name : folder.names()) {
            // What is left without such files is named as what it is; with them it is whole.
            if (unnamed || name == "a" || name == "b") expectWhole(folder, name);
            EXPECT_THAT(name, AnyOf(Eq("a"), Eq("b"), testing::StartsWith(".inkedge-")));
        }
    });
}

}  // namespace
