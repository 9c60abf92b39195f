#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace inkedge::io {

enum class PictureFormat { Png, Tiff, OpenExr, Npz };
enum class LinesFormat { Svg, Pdf, Dxf, LinesJson };
using OutputFormat = std::variant<PictureFormat, LinesFormat>;

/// The format of files of this name, by its extension in whatever case; none: it is not written.
[[nodiscard]] std::optional<OutputFormat> outputFormat(const std::filesystem::path&);

/// The same of formats of one kind: PictureFormat or LinesFormat.
template <class Format>
[[nodiscard]] std::optional<Format> formatOf(const std::filesystem::path& file) {
    const std::optional<OutputFormat> format = outputFormat(file);
    if (!format || !std::holds_alternative<Format>(*format)) return {};
    return std::get<Format>(*format);
}

/// Whether what lies under the lines, and strokes of varying width, can be drawn in it.
[[nodiscard]] constexpr bool holdsAreas(LinesFormat format) noexcept {
    return format == LinesFormat::Svg || format == LinesFormat::Pdf;
}

/// Whether a file of the format holds the picture and all maps; else each has a file of its own.
[[nodiscard]] constexpr bool holdsAllMaps(PictureFormat format) noexcept {
    return format == PictureFormat::OpenExr || format == PictureFormat::Npz;
}

/// The extensions of all formats of one kind, as in ".png, .tif, .tiff or .exr".
[[nodiscard]] std::string pictureExtensions();
[[nodiscard]] std::string linesExtensions();

/// @throws Error  (Kind::Usage) if the name's extension is that of no picture
[[nodiscard]] PictureFormat pictureFormat(const std::filesystem::path&);

/// @throws Error  (Kind::Usage) if nothing is written to files of this name
void expectOutputFormat(const std::filesystem::path&);

}  // namespace inkedge::io
