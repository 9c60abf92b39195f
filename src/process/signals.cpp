#include "process/signals.h"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <inkedge/error.h>

#include "base/temporary_name.h"

namespace inkedge::process {
namespace {

// Everything from here to handleSignals() runs in signal handlers: only async-signal-safe calls.

void say(std::string_view line) noexcept {
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;  // there is nothing left to do
}

void endInterrupted(int signal) {
    base::removeTemporaryFiles();
    say("inkedge: error: expected to come to the end, found ");
    say(signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP");
    say("; no file is half-written, start again\n");
    ::_exit(128 + signal);
}

// The default action follows, so that the caller sees the crash and may keep its core.
void endCrashed(int signal) {
    base::removeTemporaryFiles();
    say("inkedge: error: expected the program and the graphics driver to go on, found a crash (");
    say(signal == SIGABRT   ? "SIGABRT"
        : signal == SIGSEGV ? "SIGSEGV"
        : signal == SIGBUS  ? "SIGBUS"
                            : "SIGFPE or SIGILL");
    say("); see inkedge doctor, try another --backend or give it more memory\n");
    ::raise(signal);
}

std::string* timeoutLine = nullptr;

void endLate(int) {
    base::removeTemporaryFiles();
    say(*timeoutLine);
    ::_exit(static_cast<int>(Error::Kind::Runtime));
}

void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    ::sigfillset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

bool hasDefaultAction(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && (action.sa_flags & SA_SIGINFO) == 0 &&
           action.sa_handler == SIG_DFL;
}

// A stack that has overflowed has no room for a handler.
void provideHandlerStack() {
    static char memory[64 * 1024];
    stack_t stack{};
    stack.ss_sp = memory;
    stack.ss_size = sizeof memory;
    ::sigaltstack(&stack, nullptr);
}

}  // namespace

void handleSignals() {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        if (hasDefaultAction(signal)) handle(signal, endInterrupted, 0);
    }
    provideHandlerStack();
    for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
        if (hasDefaultAction(signal)) handle(signal, endCrashed, SA_ONSTACK | static_cast<int>(SA_RESETHAND));
    }
    for (const int signal : {SIGPIPE, SIGXFSZ}) handle(signal, SIG_IGN, 0);
}

void limitTime(double seconds, std::string line) {
    static std::string kept;
    kept = std::move(line);
    timeoutLine = &kept;
    handle(SIGALRM, endLate, 0);
    sigset_t alarm;
    ::sigemptyset(&alarm);
    ::sigaddset(&alarm, SIGALRM);
    ::sigprocmask(SIG_UNBLOCK, &alarm, nullptr);  // the caller may have left it blocked

    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    const double microseconds = (seconds - std::floor(seconds)) * 1e6;
    timer.it_value.tv_usec = static_cast<suseconds_t>(microseconds);
    if (timer.it_value.tv_sec == 0) timer.it_value.tv_usec = std::max<suseconds_t>(timer.it_value.tv_usec, 1);
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace inkedge::process
