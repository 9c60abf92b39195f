// Bytes as a STEP, IGES or BREP model: the first byte says which, "0", "1" or "2". What OpenCASCADE crashes over costs
// its program alone; the promise is ours: an error, in time.
#include "fuzz/load_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return inkedge::fuzz::loadAndFrameAs({"model.step", "model.igs", "model.brep"}, {data, size});
}
