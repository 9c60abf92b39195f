#pragma once

#include <functional>
#include <mutex>

#include <inkedge/export.h>

namespace inkedge::base {

/// Lets work be stopped: until the scope ends, stopIfAsked() asks its question, on this thread and on those that
/// inRanges() and onEach() start from it. Those of scopes around it are asked too. The Python module makes scopes for
/// the shared library.
class INKEDGE_API StopScope {
public:
    /// @param stopRequested  called on any of those threads, at the same time too
    explicit StopScope(std::function<bool()> stopRequested);
    /// Takes the place of the scopes that this thread is in. On another thread: the scopes that a thread is in, which
    /// must not end before this one. Null: nothing stops what is done in it.
    explicit StopScope(const StopScope* around);
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;
    ~StopScope();

    /// The scope that this thread is in; null: none.
    [[nodiscard]] static const StopScope* current() noexcept;

private:
    friend void stopIfAsked();
    std::function<bool()> stopRequested_;
    const StopScope* around_;
    const StopScope* before_;  // of this thread
};

/// To be called between pieces of work that take a moment each: it costs a few nanoseconds.
/// @throws Error  (Kind::Stopped) if a scope that this thread is in is asked to stop
void stopIfAsked();

/// Waits for a mutex that others may hold for long.
/// @throws Error  (Kind::Stopped) as stopIfAsked() does, while waiting
[[nodiscard]] INKEDGE_API std::unique_lock<std::timed_mutex> lockUnlessStopped(std::timed_mutex&);

}  // namespace inkedge::base
