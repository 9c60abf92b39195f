#include "python/released.h"

namespace inkedge::python {

bool SignalWatch::hasRaised() {
    constexpr std::chrono::milliseconds betweenLooks{50};
    if (raised_ || std::this_thread::get_id() != owner_) return raised_;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + betweenLooks;
    const py::gil_scoped_acquire held;
    if (PyErr_CheckSignals() == 0) return false;
    exception_ = std::make_exception_ptr(py::error_already_set{});
    raised_ = true;
    return true;
}

}  // namespace inkedge::python
