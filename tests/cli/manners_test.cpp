// What a person at a terminal meets: slips of the fingers, models from a pipe, and word of how far the work is.
#include <stdlib.h>

#include <thread>

#include "cli/command.h"

namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Manners : public Command {
protected:
    // Runs with a file on stdin.
    Outcome runOn(const std::string& input, const Arguments& arguments) const {
        const auto prepare = [&input] {
            const int file = ::open(input.c_str(), O_RDONLY);
            ::dup2(file, STDIN_FILENO);
        };
        return Running{INKEDGE_COMMAND, arguments, folder_.path(), {}, prepare}.finish();
    }
};

TEST_F(Manners, NameWhatWasMeant) {
    const std::string model = asset("cube.glb");
    expectFailure(run({"rendr", model}), 2, HasSubstr("found 'rendr'; is it render? see inkedge --help"));
    expectFailure(run({"isnpect", model}), 2, HasSubstr("is it inspect?"));
    expectFailure(run({"draw", model}), 2, AllOf(HasSubstr("found 'draw'; see"), Not(HasSubstr("is it"))));
    expectFailure(run({model}), 2, HasSubstr("put render before it: inkedge render " + model + " -o FILE"));
    expectFailure(run({"render", model, "--linewidth", "3", "-o", "a.png"}), 2, HasSubstr("is it --line-width?"));
    const auto slip = [&](const std::string& flag, const std::string& text, const std::string& meant) {
        expectFailure(run({"render", model, "-o", "a.png", flag, text}), 2,
                      EndsWith("found '" + text + "'; is it " + meant + "?\n"));
    };
    slip("--kernel", "soble", "sobel");
    slip("--maps", "depht", "depth");
    slip("--preset", "papr", "paper");
    slip("--function", "hieght", "height");
    expectFailure(run({"sheet", model, "-o", "a.pdf", "--views", "front,tpo"}), 2, EndsWith("is it top?\n"));
    put(folder_ / "a.conf", "line-widht = 3\n");
    expectFailure(run({"render", model, "-o", "a.png", "--config", "a.conf"}), 2, EndsWith("is it line-width?\n"));
}

TEST_F(Manners, TakeAModelFromStdin) {
    const std::string model = asset("cube.glb");
    expectSuccess(run({"render", model, "-o", "file.png"}));
    expectSuccess(runOn(model, {"render", "-", "-o", "{model}.png"}));
    EXPECT_TRUE(contents(folder_ / "stdin.png") == contents(folder_ / "file.png"));

    const std::string triangle =
        "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid\n";
    const std::string text = file("triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectSuccess(runOn(text, {"sheet", "-", "--format", "obj", "-o", "a.pdf"}));
    const Outcome inspected = runOn(text, {"inspect", "-", "--format", "obj"});
    expectSuccess(inspected);
    EXPECT_THAT(inspected.out, StartsWith("stdin.obj: OBJ\n"));
    EXPECT_THAT(runOn(file("stl", triangle), {"inspect", "-"}).out, StartsWith("stdin: STL\n"));
}

TEST_F(Manners, SayWhatIsWrongWithAModelFromStdin) {
    const std::string model = asset("cube.glb");
    expectFailure(runOn("/dev/null", {"inspect", "-"}), 3,
                  HasSubstr("stdin: expected the bytes of a model, found none"));
    expectFailure(runOn(file("x", "hello"), {"inspect", "-"}), 3, HasSubstr("say which it is: --format"));
    expectFailure(runOn(model, {"inspect", "-", "--max-file-size", "100"}), 3,
                  HasSubstr("stdin: expected a model, found more than 100 bytes"));
    expectFailure(runOn(model, {"render", "-", "-", "-o", "{model}.png"}), 2, HasSubstr("expected - once"));
    expectFailure(run({"render", model, "--format", "glb", "-o", "a.png"}), 2, HasSubstr("expected the model -"));
    expectFailure(runOn(model, {"inspect", "-", "--format", "png"}), 2, HasSubstr("found 'png'"));
}

// A terminal of our own, which the command gets as its stderr.
class Terminal {
public:
    Terminal() : descriptor_{::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)} {
        if (descriptor_ < 0 || ::grantpt(descriptor_) != 0 || ::unlockpt(descriptor_) != 0)
            throw std::runtime_error{"no terminal"};
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() { ::close(descriptor_); }

    void become(int stream) const { ::dup2(::open(::ptsname(descriptor_), O_RDWR | O_NOCTTY), stream); }

    // What it is told until that has a text in it, or a while has passed.
    std::string readUntil(const std::string& text) {
        constexpr int milliseconds = 60'000;
        pollfd ready{descriptor_, POLLIN, 0};
        while (told_.find(text) == std::string::npos && ::poll(&ready, 1, milliseconds) > 0) {
            std::array<char, 4096> bytes;
            const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
            if (count <= 0) break;  // its other end is closed
            told_.append(bytes.data(), static_cast<std::size_t>(count));
        }
        return told_;
    }

private:
    int descriptor_;
    std::string told_;
};

TEST_F(Manners, SayOnATerminalHowFarTheWorkIs) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
    Terminal terminal;
    const auto prepare = [&] {
        ::dup2(pipe[0], STDIN_FILENO);
        terminal.become(STDERR_FILENO);
    };
    Running running{INKEDGE_COMMAND,
                    {"render", "-", "-o", "a.png", "--size", "64x64"},
                    folder_.path(),
                    {{"TERM", "xterm"}},
                    prepare};
    EXPECT_THAT(terminal.readUntil("reading -, 1 s"), HasSubstr("\r\x1b[Kreading -, 1 s"));
    const std::string model = contents(asset("cube.glb"));
    EXPECT_EQ(::write(pipe[1], model.data(), model.size()), static_cast<ssize_t>(model.size()));
    ::close(pipe[1]);
    ::close(pipe[0]);
    expectSuccess(running.finish());
    EXPECT_THAT(terminal.readUntil("\x1b[K\n"), EndsWith("\r\x1b[K"));  // there is no such text: to the end
}

TEST_F(Manners, SayNothingOfItInAPipe) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
    const auto prepare = [&] { ::dup2(pipe[0], STDIN_FILENO); };
    Running running{INKEDGE_COMMAND,
                    {"render", "-", "-o", "a.png", "--size", "64x64"},
                    folder_.path(),
                    {{"TERM", "xterm"}},
                    prepare};
    std::this_thread::sleep_for(std::chrono::milliseconds{1500});
    const std::string model = contents(asset("cube.glb"));
    EXPECT_EQ(::write(pipe[1], model.data(), model.size()), static_cast<ssize_t>(model.size()));
    ::close(pipe[1]);
    ::close(pipe[0]);
    const Outcome outcome = running.finish();
    expectSuccess(outcome);
    EXPECT_THAT(outcome.error, IsEmpty());
}

}  // namespace
