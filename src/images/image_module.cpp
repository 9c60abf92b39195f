#include "images/image_module.h"

#include "modules/open_module.h"

namespace fs = std::filesystem;

namespace inkedge::io {
namespace {

constexpr Module imageModule{.purpose = "image formats",
                             .file = imageFormatsFile,
                             .symbol = imageFormatsSymbol,
                             .library = "OpenImageIO",
                             .remedy = "use .png, which needs no module"};

const ImageFormats& formatsBehind(void* symbol) {
    return *reinterpret_cast<decltype(&inkedge_image_formats_3)>(symbol)();
}

}  // namespace

const ImageFormats& imageFormats(Error::Kind failure) {
    static const ImageFormats& formats = formatsBehind(openModule(imageModule, failure));
    return formats;
}

const ImageFormats& openImageFormats(std::span<const fs::path> folders, Error::Kind failure) {
    return formatsBehind(openModule(imageModule, folders, failure));
}

}  // namespace inkedge::io
