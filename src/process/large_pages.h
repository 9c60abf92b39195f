#pragma once

namespace inkedge::process {

/// Lets the first 256 MiB of the process's heap lie in large pages, and keeps what is given back for what is asked for
/// next. Pictures and meshes are made and dropped by the megabyte: with pages of 4 KiB a third of a short process's
/// time is spent on page faults. The command has large pages under large arrays beyond it, too (cli/large_blocks.cpp).
/// To be called before there are threads. Does nothing where the system has no large pages or another C library than
/// glibc.
void useLargePages();

}  // namespace inkedge::process
