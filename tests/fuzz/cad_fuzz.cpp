// Bytes as a STEP, IGES or BREP model: the first byte says which, "0", "1" or "2". What OpenCASCADE crashes over costs
// its program alone; the promise is ours: an error, in time.
#include <array>

#include "base/temporary_folder.h"
#include "fuzz/load_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace inkedge::fuzz;
    constexpr std::array names{"model.step", "model.igs", "model.brep"};
    static const TemporaryFolder folder;
    if (size == 0) return -1;
    const std::filesystem::path model = folder / names[data[0] % names.size()];
    write(model, {data + 1, size - 1});
    loadAndFrame(model);
    return 0;
}
