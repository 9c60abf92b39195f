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
    const std::string text = *format == io::LinesFormat::Svg ? linesSvg(lines, settings, file.filename().string())
                                                             : linesJson(lines, settings);
    writeFile(file, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace inkedge
