// Faults from outside: full disks, closed streams, signals. The right exit code, a line that says what to do, and files
// that are whole or not there. The table of faults is in tests/README.md.
#include <thread>

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "cli/decode_png.h"
#include "cli/faults.h"

namespace {

using namespace faults;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::Eq;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// --- stdout and stderr ---

class Streams : public Faults {
protected:
    std::string picture() const {
        const std::string name = models_ / "picture.png";
        expectSuccess(run({"render", roof(), "-o", name, "--size", "16x16"}));
        return name;
    }

    /// Every way to print a result, on such a stdout.
    void expectNoWayToPrint(const Prepare& prepare, const std::string& found) const {
        const std::string some = picture();
        for (const Arguments& arguments :
             {Arguments{"--version"}, Arguments{"--help"}, Arguments{"render", "--help"}, Arguments{"doctor"},
              Arguments{"doctor", "--json"}, Arguments{"compare", some, some},
              Arguments{"compare", some, some, "--json"}, Arguments{"render", roof(), "-o", "-", "--size", "16x16"}}) {
            expectFailure(runWith(prepare, arguments), 5,
                          HasSubstr("stdout: expected it to take the result, found " + found));
        }
        expectNothingLeft();
        expectFailure(runWith(prepare, {"render", roof(), "-o", "a.png", "--size", "16x16", "--json"}), 5,
                      HasSubstr("stdout: "));
        EXPECT_EQ(decodePng(contents(folder_ / "a.png")).width, 16U);
    }
};

TEST_F(Streams, StdoutThatIsClosed) {
    expectNoWayToPrint([] { ::close(STDOUT_FILENO); }, "it closed; redirect it");
}

TEST_F(Streams, StdoutThatIsFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    expectNoWayToPrint([] { giveDevice(STDOUT_FILENO, "/dev/full"); }, "No space left on device; redirect it");
}

TEST_F(Streams, StdoutThatNobodyReads) {
    expectNoWayToPrint(
        [] {
            std::array<int, 2> ends{};
            if (::pipe(ends.data()) == 0) ::dup2(ends[1], STDOUT_FILENO);
            for (const int end : ends) ::close(end);
        },
        "a pipe that nobody reads any more; read it");
}

TEST_F(Streams, StderrThatTakesNothingChangesNothing) {
    for (const Prepare& prepare :
         {Prepare{[] { ::close(STDERR_FILENO); }}, Prepare{[] { giveDevice(STDERR_FILENO, "/dev/full"); }}}) {
        EXPECT_EQ(runWith(prepare, {"render", "missing.glb", "-o", "a.png"}).exitCode, 3);
        EXPECT_EQ(runWith(prepare, {"draw"}).exitCode, 2);
        EXPECT_EQ(runWith(prepare, {"render", roof(), "-o", "a.png", "--size", "16x16", "-v"}).exitCode, 0);
    }
}

// --- targets that take no file ---

class Targets : public Faults {};

TEST_F(Targets, DiskThatIsFull) {
    const auto full = [] { limit(RLIMIT_FSIZE, 300); };
    for (const char* output : {"a.png", "a.tif", "a.exr"}) {
        expectFailure(runWith(full, {"render", roof(), "-o", output, "--maps", "depth,normal"}), 5,
                      AllOf(HasSubstr(output), HasSubstr("cannot be written: expected room for the file, found: "),
                            HasSubstr("; ")));
        expectNothingLeft();
    }
    for (const char* output : {"a.svg", "a.json"}) {
        expectFailure(runWith(full, {"render", roof(), "-o", output, "--lines-from", "image"}), 5,
                      AllOf(HasSubstr(output), HasSubstr("cannot be written: expected room for the file, found: ")));
        expectNothingLeft();
    }
}

TEST_F(Targets, DiskThatIsFullKeepsTheOlderPicture) {
    put(folder_ / "a.png", "older");
    EXPECT_EQ(runWith([] { limit(RLIMIT_FSIZE, 300); }, {"render", roof(), "-o", "a.png"}).exitCode, 5);
    EXPECT_EQ(contents(folder_ / "a.png"), "older");
    EXPECT_THAT(folder_.names(), testing::ElementsAre("a.png"));
}

/// Modes hold for root too once it has given up this right.
constexpr int cannotObeyModes = 77;
void obeyModes() {
    if (::geteuid() == 0 && ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) != 0) ::_exit(cannotObeyModes);
}

TEST_F(Targets, FolderThatIsReadOnly) {
    for (const std::string output : {"a.png", "a.svg", "a.json"}) {
        std::filesystem::permissions(folder_.path(), std::filesystem::perms{0555});
        const Outcome outcome = runWith(obeyModes, {"render", roof(), "-o", output, "--lines-from", "image"});
        std::filesystem::permissions(folder_.path(), std::filesystem::perms{0755});
        if (outcome.exitCode == cannotObeyModes) GTEST_SKIP() << "root may write to every folder here";
        expectFailure(outcome, 5,
                      HasSubstr(output + ": cannot be written: expected a place that may be written to, found: "
                                         "Permission denied; choose another or change its mode"));
        expectNothingLeft();
    }
}

TEST_F(Targets, FileThatIsReadOnly) {
    put(folder_ / "a.png", "older");
    std::filesystem::permissions(folder_ / "a.png", std::filesystem::perms{0444});
    const Outcome outcome = runWith(obeyModes, {"render", roof(), "-o", "a.png"});
    if (outcome.exitCode == cannotObeyModes) GTEST_SKIP() << "root may write to every file here";
    expectFailure(outcome, 5, HasSubstr("a.png: cannot be written: expected a place that may be written to"));
    EXPECT_EQ(contents(folder_ / "a.png"), "older");
    EXPECT_THAT(folder_.names(), testing::ElementsAre("a.png"));
}

/// The depth map goes to a pipe that is read only when the test wants it, so that the command stands in the middle of
/// its writing: picture.png is written but has not its name yet, the normal map is still to come.
class HalfWay : public Faults {
protected:
    void SetUp() override {
        std::filesystem::create_directory(folder_ / "out");
        ASSERT_EQ(::mkfifo((folder_ / "out/picture.depth.png").c_str(), 0600), 0);
        pipe_ = ::open((folder_ / "out/picture.depth.png").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        ASSERT_GE(::fcntl(pipe_, F_SETPIPE_SZ, 4096), 0);
    }
    void TearDown() override { ::close(pipe_); }

    Arguments command() const {
        return {"render", asset("teapot.glb"), "-o", "out/picture.png", "--size", "400x400", "--maps", "depth,normal"};
    }
    /// Returns once the command waits for the pipe, which takes a part of the map only.
    void expectWriting() const {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{60};
        pollfd filled{pipe_, POLLIN, 0};
        while (::poll(&filled, 1, 1000) == 0 || (filled.revents & POLLIN) == 0) {  // the last command may have hung up
            ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "expected the command to write the depth map";
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
    }
    /// Empties the pipe until the command has closed it.
    void readOn() const {
        std::array<char, 4096> bytes;
        pollfd filled{pipe_, POLLIN, 0};
        while (::poll(&filled, 1, 60'000) == 1 && (filled.revents & POLLIN) != 0) {
            (void)!::read(pipe_, bytes.data(), bytes.size());
        }
    }
    std::vector<std::string> left() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator{folder_ / "out"}) {
            if (entry.path().filename() != "picture.depth.png") names.push_back(entry.path().filename());
        }
        return names;
    }

    int pipe_ = -1;
};

// A file that gets the number of stderr gets the messages of libraries too.
TEST_F(HalfWay, StreamsThatAreClosedLendTheirNumbersToNoFile) {
    const auto closeAll = [] {
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(stream);
    };
    Running running{INKEDGE_COMMAND, command(), folder_.path(), {}, closeAll};
    expectWriting();
    const std::filesystem::path streams = "/proc/" + std::to_string(running.process()) + "/fd";
    for (const char* stream : {"0", "1", "2"}) {
        EXPECT_EQ(std::filesystem::read_symlink(streams / stream), "/dev/null") << stream;
    }
    readOn();
    expectSuccess(running.finish());
}

TEST_F(HalfWay, FolderThatVanishes) {
    Running running{INKEDGE_COMMAND, command(), folder_.path()};
    expectWriting();
    std::filesystem::remove_all(folder_ / "out");
    readOn();
    expectFailure(running.finish(), 5,
                  HasSubstr("cannot be written: expected a folder out, found none; create it first"));
    expectNothingLeft();
}

TEST_F(HalfWay, SignalThatInterrupts) {
    for (const auto& [signal, name] : {std::pair{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}}) {
        Running running{INKEDGE_COMMAND, command(), folder_.path()};
        expectWriting();
        ::kill(running.process(), signal);
        expectError(running.finish(), 128 + signal,
                    HasSubstr(std::string{"expected to come to the end, found "} + name +
                              "; no file is half-written, start again"));
        EXPECT_THAT(left(), IsEmpty());
        readOn();
    }
}

TEST_F(HalfWay, SignalThatTheCallerIgnores) {
    Running running{INKEDGE_COMMAND, command(), folder_.path(), {}, [] { ::signal(SIGHUP, SIG_IGN); }};
    expectWriting();
    ::kill(running.process(), SIGHUP);
    readOn();
    expectSuccess(running.finish());
    EXPECT_THAT(left(), testing::UnorderedElementsAre("picture.png", "picture.normal.png"));
}

TEST_F(HalfWay, Kill) {
    Running running{INKEDGE_COMMAND, command(), folder_.path()};
    expectWriting();
    const std::vector<std::string> before = left();  // names, where the file system has no files without one
    ::kill(running.process(), SIGKILL);
    EXPECT_EQ(running.finish().exitCode, 128 + SIGKILL);
    EXPECT_THAT(left(), testing::Not(Contains("picture.png")));
    EXPECT_EQ(left(), before);
}

TEST_F(HalfWay, CrashIsToldAndLeavesNothing) {
    Running running{INKEDGE_COMMAND, command(), folder_.path(), {}, [] { limit(RLIMIT_CORE, 0); }};
    expectWriting();
    ::kill(running.process(), SIGABRT);
    const Outcome outcome = running.finish();
    EXPECT_EQ(outcome.exitCode, 128 + SIGABRT);
    EXPECT_THAT(outcome.error,
                HasSubstr("inkedge: error: expected the program and the graphics driver to go on, found a "
                          "crash (SIGABRT); see inkedge doctor"));
    EXPECT_THAT(left(), IsEmpty());
}

TEST_F(HalfWay, TimeThatIsOver) {
    Arguments limited = command();
    limited.insert(limited.end(), {"--timeout", "2"});
    Running running{INKEDGE_COMMAND, limited, folder_.path()};
    expectFailure(running.finish(), 1,
                  HasSubstr("teapot.glb: expected the work to end within 2 s, found it still "
                            "going; raise --timeout or ask for less"));
    EXPECT_THAT(left(), IsEmpty());
}

// --- signals at any moment ---

class AnyMoment : public Faults {
protected:
    /// Renders into a folder of its own, with older pictures in it or without, and signals after a while.
    void interruptOften(int signal) const {
        const Arguments command{"render",  asset("bracket.glb"), "-o", "a.png", "--size", "300x300", "--maps",
                                everyMap()};
        const TemporaryFolder whole;
        const auto begin = std::chrono::steady_clock::now();
        expectSuccess(runCommand(INKEDGE_COMMAND, command, whole.path()));
        const auto duration = std::chrono::steady_clock::now() - begin;
        constexpr int moments = 20;
        int interrupted = 0;
        for (int i = 0; i < moments; ++i) {
            const TemporaryFolder folder;
            if (i % 2 == 0) std::filesystem::copy(whole.path(), folder.path());
            Running running{INKEDGE_COMMAND, command, folder.path()};
            std::this_thread::sleep_for(duration * i / (moments - 1));
            ::kill(running.process(), signal);
            const Outcome outcome = running.finish();
            ASSERT_THAT(outcome.exitCode, AnyOf(Eq(0), Eq(128 + signal))) << outcome.error;
            interrupted += outcome.exitCode == 0 ? 0 : 1;
            expectWholeFiles(folder, signal);
            if (outcome.exitCode == 0 || i % 2 == 0) {
                EXPECT_THAT(folder.names(), testing::IsSupersetOf(whole.names()));
            }
            if (HasFailure()) return;
        }
        EXPECT_GT(interrupted, 0);
    }

private:
    // Only who is killed cannot clean up.
    static void expectWholeFiles(const TemporaryFolder& folder, int signal) {
        for (const std::string& name : folder.names()) {
            if (signal == SIGKILL && name.starts_with(".inkedge-")) continue;
            EXPECT_THAT(name, StartsWith("a."));
            EXPECT_EQ(decodePng(contents(folder / name)).width, 300U) << name;
        }
    }
};

TEST_F(AnyMoment, SigintLeavesWholeFilesOnly) { interruptOften(SIGINT); }

TEST_F(AnyMoment, SigtermLeavesWholeFilesOnly) { interruptOften(SIGTERM); }

TEST_F(AnyMoment, SigkillLeavesNoFileInPart) { interruptOften(SIGKILL); }

// --- drivers ---

class Drivers : public Faults {};

TEST_F(Drivers, DoctorSurvivesOneThatCrashes) {
    const Outcome outcome = run({"doctor", "--json"}, {{"GALLIUM_DRIVER", "nope"}});
    EXPECT_THAT(outcome.exitCode, AnyOf(Eq(0), Eq(4))) << outcome.error;
    const auto backends = nlohmann::json::parse(outcome.out)["backends"];
    EXPECT_GE(backends.size(), 2U);
    for (const auto& backend : backends) {
        if (backend["works"]) continue;
        EXPECT_THAT(backend["failure"].get<std::string>(), AllOf(HasSubstr("expected "), HasSubstr("found ")));
    }
}

}  // namespace
