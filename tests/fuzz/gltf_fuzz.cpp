// Bytes as a glTF model, with one file beside it that it may name: data.bin.
#include <array>

#include "base/temporary_folder.h"
#include "fuzz/load_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace inkedge::fuzz;
    static const TemporaryFolder folder;
    static const bool once = [] {
        std::array<std::uint8_t, 4096> bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i % 3);
        write(folder / "data.bin", bytes);
        return true;
    }();
    static_cast<void>(once);
    write(folder / "model.glb", {data, size});
    loadAndFrame(folder / "model.glb");
    return 0;
}
