#include <inkedge/write.h>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "io/output_formats.h"

namespace inkedge {

bool holdsLines(const std::filesystem::path& file) { return io::formatOf<io::LinesFormat>(file).has_value(); }

void writeLines(const Lines& lines, const Settings& settings, const std::filesystem::path& file) {
    const std::optional<io::LinesFormat> format = io::formatOf<io::LinesFormat>(file);
    if (!format) {
        throw Error{Error::Kind::Usage, fmt::format("{}: expected a file name that ends in {}, found '{}'",
                                                    file.string(), io::linesExtensions(), file.extension().string())};
    }
    const std::string title = file.filename().string();
    const auto bytesOf = [](const std::string& text) { return std::vector<std::uint8_t>(text.begin(), text.end()); };
    switch (*format) {
        case io::LinesFormat::Svg:
            return writeFile(file, bytesOf(linesSvg(lines, settings, title)));
        case io::LinesFormat::Pdf:
            return writeFile(file, linesPdf(lines, settings, title));
        case io::LinesFormat::Dxf:
            return writeFile(file, bytesOf(linesDxf(lines, settings)));
        case io::LinesFormat::LinesJson:
            return writeFile(file, bytesOf(linesJson(lines, settings)));
    }
}

}  // namespace inkedge
