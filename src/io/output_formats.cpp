#include "io/output_formats.h"

#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

#include "base/file_extension.h"

namespace inkedge::io {
namespace {

struct Extension {
    std::string_view text;
    OutputFormat format;
};
constexpr std::array extensions{
    Extension{".png", PictureFormat::Png},      Extension{".tif", PictureFormat::Tiff},
    Extension{".tiff", PictureFormat::Tiff},    Extension{".exr", PictureFormat::OpenExr},
    Extension{".npz", PictureFormat::Npz},      Extension{".svg", LinesFormat::Svg},
    Extension{".pdf", LinesFormat::Pdf},        Extension{".dxf", LinesFormat::Dxf},
    Extension{".json", LinesFormat::LinesJson},
};

template <class Format>
std::string extensionsOf() {
    std::vector<std::string_view> texts;
    for (const Extension& extension : extensions)
        if (std::holds_alternative<Format>(extension.format)) texts.push_back(extension.text);
    const std::string_view last = texts.back();
    texts.pop_back();
    return fmt::format("{} or {}", fmt::join(texts, ", "), last);
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& expected) {
    const std::string extension = base::lowerCaseExtension(file);
    throw Error{Error::Kind::Usage, fmt::format("{}: expected a name that ends in {}, found {}", file.string(),
                                                expected, extension.empty() ? "no extension" : extension)};
}

}  // namespace

std::optional<OutputFormat> outputFormat(const std::filesystem::path& file) {
    const std::string extension = base::lowerCaseExtension(file);
    for (const Extension& known : extensions)
        if (extension == known.text) return known.format;
    return {};
}

std::string pictureExtensions() { return extensionsOf<PictureFormat>(); }
std::string linesExtensions() { return extensionsOf<LinesFormat>(); }

PictureFormat pictureFormat(const std::filesystem::path& file) {
    const std::optional<PictureFormat> format = formatOf<PictureFormat>(file);
    if (!format) refuse(file, pictureExtensions());
    return *format;
}

void expectOutputFormat(const std::filesystem::path& file) {
    if (!outputFormat(file))
        refuse(file, fmt::format("{}, or for lines in {}", pictureExtensions(), linesExtensions()));
}

}  // namespace inkedge::io
