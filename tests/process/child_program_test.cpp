#include "process/child_program.h"

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

TEST(ChildProgram, isNotLateBecauseTheMachineIsBusy) {
    ChildProgram child = shell(R"(sleep 0.5; printf '\002\0\0\0\0\0\0\0ok' >&4)", "", duration<double>{0.2});
    EXPECT_EQ(child.receive(), bytes("ok"));
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
