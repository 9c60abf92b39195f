#pragma once

#include <functional>
#include <memory>
#include <mutex>

namespace inkedge::scene {

/// Something that is made once for all who want it at the same time, and kept as long as one of them holds it. What is
/// made may hold what this is part of: it is not held from here.
class SharedOnce {
public:
    /// What make() returns: called by the first who wants it, while others wait, and again once nobody holds it any
    /// more. Thread-safe. Always of the same type, which is the caller's to know.
    /// @throws  what make() throws, to its caller alone: the next one tries again; Error (Kind::Stopped) as
    ///          stopIfAsked() does, while waiting
    [[nodiscard]] std::shared_ptr<const void> get(const std::function<std::shared_ptr<const void>()>& make);

    /// How many hold it now.
    [[nodiscard]] long holders() const;

private:
    mutable std::timed_mutex mutex_;
    std::weak_ptr<const void> made_;
};

}  // namespace inkedge::scene
