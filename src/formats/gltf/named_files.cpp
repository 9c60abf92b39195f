#include "formats/gltf/named_files.h"

#include <string>

#include <inkedge/error.h>

#include "formats/gltf/uri.h"

namespace inkedge::gltf {

std::vector<std::filesystem::path> namedFiles(const formats::ModelInput& input, const Json& document) {
    std::vector<std::filesystem::path> files;
    if (!input.isFile()) return files;
    for (const char* list : {"buffers", "images"}) {
        for (const Json& each : member(document, list)) {
            const Json& uri = member(each, "uri");
            if (!uri.is_string() || isDataUri(uri.get_ref<const std::string&>())) continue;
            try {
                files.push_back(fileOfUri(input.name, uri.get_ref<const std::string&>()));
            } catch (const Error&) {  // who reads it says so
            }
        }
    }
    return files;
}

}  // namespace inkedge::gltf
