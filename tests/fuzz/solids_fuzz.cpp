// Bytes as a 3MF model or an implicit surface: the first byte says which, "0" or "1". After "2" come the XML of a model
// and, after a zero byte, of another file that it may name, which are packed here: hardly an archive that was changed
// at random is one still.
#include <algorithm>
#include <string>
#include <vector>

#include "formats/cad/threemf_files.h"
#include "fuzz/load_promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace inkedge;
    std::vector<std::uint8_t> bytes{data, data + size};
    if (size > 0 && bytes.front() == '2') {
        const auto end = std::find(bytes.begin(), bytes.end(), 0);
        std::vector<threemf_files::Member> others;
        if (end != bytes.end()) others.emplace_back("3D/Objects/one.model", std::string{end + 1, bytes.end()});
        bytes = threemf_files::archive(std::string{bytes.begin() + 1, end}, others);
        bytes.insert(bytes.begin(), '0');
    }
    return fuzz::loadAndFrameAs({"model.3mf", "model.implicit"}, bytes);
}
