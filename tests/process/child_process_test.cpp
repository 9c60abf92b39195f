// Trials in a process of their own.
#include "process/child_process.h"

#include <signal.h>
#include <unistd.h>

#include <stdexcept>

#include <gmock/gmock.h>

namespace {

using inkedge::process::Answer;
using inkedge::process::answerOfChild;
using testing::StartsWith;

constexpr std::chrono::seconds longest{60};

TEST(AnswerOfChild, isWhatTheWorkReturns) {
    const std::string text(200'000, 'x');  // more than a pipe holds
    const Answer answer = answerOfChild([&] { return text; }, longest);
    EXPECT_EQ(answer.text, text);
    EXPECT_EQ(answer.failure, "");
}

TEST(AnswerOfChild, namesACrash) {
    const Answer answer = answerOfChild(
        []() -> std::string {
            ::signal(SIGSEGV, SIG_DFL);
            ::raise(SIGSEGV);
            return "";
        },
        longest);
    EXPECT_EQ(answer.failure, "found a crash (Segmentation fault)");
}

TEST(AnswerOfChild, reportsAnException) {
    const Answer answer = answerOfChild([]() -> std::string { throw std::runtime_error{"no"}; }, longest);
    EXPECT_THAT(answer.failure, StartsWith("found exit status "));
}

TEST(AnswerOfChild, doesNotWaitForEver) {
    const Answer answer = answerOfChild(
        []() -> std::string {
            for (;;) ::pause();
        },
        std::chrono::seconds{1});
    EXPECT_EQ(answer.failure, "found it still going after 1 s");
}

}  // namespace
