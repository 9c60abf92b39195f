#pragma once

#include <cstddef>

namespace inkedge::base {

/// How many threads can be started beside those there are, up to a number: they are started, and ended at once.
/// Libraries that start some may end the process, or wait for ever, where they get none.
[[nodiscard]] std::size_t startableThreads(std::size_t wanted);

}  // namespace inkedge::base
