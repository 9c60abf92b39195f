#include "process/driver_threads.h"

#include <cstdlib>

namespace inkedge::process {

void drawInCallingThreads() {
    constexpr int keep = 0;
    ::setenv("LP_NUM_THREADS", "0", keep);
}

}  // namespace inkedge::process
