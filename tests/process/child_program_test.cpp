#include "process/child_program.h"

#include <sched.h>
#include <signal.h>

#include <array>
#include <chrono>
#include <string>

#include <gmock/gmock.h>

#include <inkedge/error.h>

#include "base/expect_error.h"

namespace inkedge::process {
namespace {

using std::chrono::duration;
using testing::HasSubstr;
using testing::StrEq;

constexpr duration<double> longEnough{30.0};

std::vector<std::uint8_t> bytes(std::string_view text) { return {text.begin(), text.end()}; }

ChildProgram shell(const std::string& script, std::string_view file = "", duration<double> limit = longEnough) {
    return ChildProgram{"/bin/sh", {"-c", script}, bytes(file), limit, [] {}};
}

TEST(ChildProgram, findsItsBytesAndAnswers) {
    // Eight bytes of a size, then the message; the shell's printf writes any byte.
    ChildProgram child = shell(R"(read word <&3; printf '\005\0\0\0\0\0\0\0%s' "$word" >&4)", "hello\n");
    EXPECT_EQ(child.receive(), bytes("hello"));
}

TEST(ChildProgram, receivesMessages) {
    ChildProgram child = shell(R"(head -c 11 <&4 | tail -c 3 >/dev/null; printf '\002\0\0\0\0\0\0\0ok' >&4)");
    child.send(bytes("you"));
    EXPECT_EQ(child.receive(), bytes("ok"));
}

TEST(ChildProgram, saysHowAProgramEnded) {
    expectError(Error::Kind::Input, StrEq("found a crash (Segmentation fault)"),
                [] { static_cast<void>(shell("kill -SEGV $$").receive()); });
    expectError(Error::Kind::Input, StrEq("found exit status 3"), [] { static_cast<void>(shell("exit 3").receive()); });
    expectError(Error::Kind::Input, StrEq("found exit status 0"),
                [] { static_cast<void>(shell(R"(printf '\005\0\0\0\0\0\0\0he' >&4)").receive()); });
}

TEST(ChildProgram, endsAProgramAtItsLimit) {
    for (const char* script : {"while :; do :; done", "sleep 60"}) {
        expectError(Error::Kind::Input, StrEq("found it still at work after 0.2 s"),
                    [&] { static_cast<void>(shell(script, "", duration<double>{0.2}).receive()); });
    }
}

// It stops, is late by the clock, and goes on.
TEST(ChildProgram, isNotLateWhileItIsStopped) {
    const auto start = std::chrono::steady_clock::now();
    pid_t process = -1;
    ChildProgram child{"/bin/sh", {"-c", R"(kill -STOP $$; printf '\002\0\0\0\0\0\0\0ok' >&4)"}, {},
                       duration<double>{0.3}, [&] {
                           if (process > 0 && std::chrono::steady_clock::now() - start > duration<double>{1.0})
                               ::kill(process, SIGCONT);
                       }};
    process = child.process();
    EXPECT_EQ(child.receive(), bytes("ok"));
    EXPECT_GT(std::chrono::steady_clock::now() - start, duration<double>{1.0});
}

// It shares a processor with others that are at work all the time, and has a tenth of it: its work takes longer than
// the limit by the clock, but not by the processor's, on processors from a third to three times as fast as an EPYC of
// 2024.
TEST(ChildProgram, isNotLateBecauseTheMachineIsBusy) {
    const auto start = std::chrono::steady_clock::now();
    constexpr duration<double> limit{1.5};
    const std::string alone = "taskset -p -c " + std::to_string(::sched_getcpu()) + " $$ >&2; ";
    const std::string busy = alone + "while :; do :; done";
    const std::array<ChildProgram, 9> others{shell(busy), shell(busy), shell(busy), shell(busy), shell(busy),
                                             shell(busy), shell(busy), shell(busy), shell(busy)};
    const std::string work = "i=0; while [ $i -lt 500000 ]; do i=$((i + 1)); done; ";
    ChildProgram child = shell(alone + work + R"(printf '\002\0\0\0\0\0\0\0ok' >&4)", "", limit);
    EXPECT_EQ(child.receive(), bytes("ok"));
    EXPECT_GT(std::chrono::steady_clock::now() - start, limit) << "it had a processor for itself";
}

TEST(ChildProgram, isLeftWhenWaitingThrows) {
    ChildProgram child{"/bin/sh", {"-c", "sleep 60"}, {}, longEnough, [] {
                           throw Error{Error::Kind::Stopped, "stop"};
                       }};
    expectError(Error::Kind::Stopped, StrEq("stop"), [&] { static_cast<void>(child.receive()); });
}

TEST(ChildProgram, saysThatAProgramIsNotThere) {
    expectError(Error::Kind::Runtime, HasSubstr("expected a process for reading the file, found none: No such file"),
                [] {
                    const ChildProgram child{"/no/such/program", {}, {}, longEnough, [] {}};
                });
}

}  // namespace
}  // namespace inkedge::process
