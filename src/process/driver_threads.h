#pragma once

namespace inkedge::process {

/// Lets Mesa's llvmpipe draw in the thread that calls it, instead of in one more thread for each core: less work where
/// several contexts keep all cores busy (512 x 512, two contexts on two cores: a tenth less time). For contexts that
/// are made later, also in processes that are started later; does nothing if the environment has LP_NUM_THREADS. To be
/// called before there are threads.
void drawInCallingThreads();

}  // namespace inkedge::process
