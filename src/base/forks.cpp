#include "base/forks.h"

#include <unistd.h>

#include <atomic>

#include <inkedge/error.h>

namespace inkedge::base {
namespace {

std::atomic<pid_t> user{0};  // the process that has such threads

}  // namespace

bool isFork() noexcept {
    const pid_t found = user;
    return found != 0 && found != ::getpid();
}

void expectNoFork() {
    pid_t none = 0;
    user.compare_exchange_strong(none, ::getpid());
    if (isFork())
        throw Error{Error::Kind::Runtime,
                    "expected a process of its own, found a fork of one that has drawn already, whose graphics driver "
                    "does not live on in it; fork before anything is drawn, or start new processes (Python: "
                    "multiprocessing.set_start_method('spawn'))"};
}

}  // namespace inkedge::base
