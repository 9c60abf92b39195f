#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <thread>
#include <type_traits>

#include <pybind11/pybind11.h>

#include "base/stop.h"
#include "python/errors.h"

namespace inkedge::python {

/// Looks, while the GIL is released, for signals that came in. Python runs their handlers on its main thread alone,
/// and only if it is asked to.
class SignalWatch {
public:
    /// Whether a handler has raised something, as that of SIGINT does. Any thread may ask; the one that made this asks
    /// Python, some times a second.
    [[nodiscard]] bool hasRaised();

    /// Raises what a handler has raised, if one has. To be called with the GIL.
    void rethrow() const {
        if (raised_) std::rethrow_exception(exception_);
    }

private:
    std::thread::id owner_ = std::this_thread::get_id();
    std::chrono::steady_clock::time_point next_{};
    std::atomic<bool> raised_ = false;
    std::exception_ptr exception_;
};

/// Calls a function without the GIL: other threads of Python go on, and a signal whose handler raises, as Ctrl-C does,
/// ends it early.
template <class Function>
auto released(const Function& function) {
    SignalWatch watch;
    const auto call = [&] {
        const py::gil_scoped_release without;
        const base::StopScope scope{[&] { return watch.hasRaised(); }};
        return function();
    };
    try {
        if constexpr (std::is_void_v<decltype(function())>) {
            call();
            watch.rethrow();
        } else {
            auto result = call();
            watch.rethrow();
            return result;
        }
    } catch (const Error&) {
        watch.rethrow();
        throw;
    }
}

}  // namespace inkedge::python
