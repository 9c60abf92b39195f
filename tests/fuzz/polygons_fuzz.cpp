// Bytes as an OBJ, STL or PLY model: the first byte says which, "0", "1" or "2".
#include "fuzz/load_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return inkedge::fuzz::loadAndFrameAs({"model.obj", "model.stl", "model.ply"}, {data, size});
}
