#include <inkedge/write.h>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "io/encode_files.h"
#include "io/output_formats.h"

namespace inkedge {

bool holdsLines(const std::filesystem::path& file) { return io::formatOf<io::LinesFormat>(file).has_value(); }

std::vector<std::uint8_t> io::encodeLines(const Lines& lines, const Settings& settings,
                                          const std::filesystem::path& file) {
    const std::optional<io::LinesFormat> format = io::formatOf<io::LinesFormat>(file);
    if (!format) {
        throw Error{Error::Kind::Usage, fmt::format("{}: expected a file name that ends in {}, found '{}'",
                                                    file.string(), io::linesExtensions(), file.extension().string())};
    }
    const std::string title = file.filename().string();
    const auto bytesOf = [](const std::string& text) { return std::vector<std::uint8_t>(text.begin(), text.end()); };
    switch (*format) {
        case io::LinesFormat::Svg:
            return bytesOf(linesSvg(lines, settings, title));
        case io::LinesFormat::Pdf:
            return linesPdf(lines, settings, title);
        case io::LinesFormat::Dxf:
            return bytesOf(linesDxf(lines, settings));
        case io::LinesFormat::LinesJson:
            break;
    }
    return bytesOf(linesJson(lines, settings));
}

void writeLines(const Lines& lines, const Settings& settings, const std::filesystem::path& file) {
    writeFile(file, io::encodeLines(lines, settings, file));
}

}  // namespace inkedge
