#include <inkedge/write.h>

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge {
namespace {

std::string extensionOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace

bool holdsLines(const std::filesystem::path& file) {
    const std::string extension = extensionOf(file);
    return extension == ".svg" || extension == ".json";
}

void writeLines(const Scene& scene, const Lines& lines, const Settings& settings, const std::filesystem::path& file) {
    if (!holdsLines(file)) {
        throw Error{Error::Kind::Usage, fmt::format("{}: expected a file name that ends in .svg or .json, found '{}'",
                                                    file.string(), file.extension().string())};
    }
    const std::string text = extensionOf(file) == ".svg" ? linesSvg(scene, lines, settings, file.filename().string())
                                                         : linesJson(scene, lines, settings);
    writeFile(file, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace inkedge
