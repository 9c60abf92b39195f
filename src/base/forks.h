#pragma once

namespace inkedge::base {

/// Notes that this process has what no fork of it can use: the threads of graphics drivers and of Embree.
/// @throws Error  (Kind::Runtime) in a fork of a process that has noted so
void expectNoFork();

/// Whether this is a fork of a process that has noted so.
[[nodiscard]] bool isFork() noexcept;

}  // namespace inkedge::base
