#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/setting_table.h>

/// Converts text to values and back. A text that has no value throws Expected or, if there is more to say, Error.
/// SettingDescription::set() turns an Expected into an Error.
namespace inkedge::settings {

/// Thrown for a text that has no value: what was expected.
struct Expected {
    std::string what;
    std::string remedy = {};  ///< added to the message
};

/// The width of a line's pen in output pixels.
inline constexpr Number penWidth{.min = 0.5, .max = 32.0, .unit = "PX"};
/// The number of isolines within one unit of a texture coordinate.
inline constexpr Count isolineSteps{.max = 1000};
/// Levels of refinement.
inline constexpr Count subdivisionLevels{.max = 6};
/// Where a light comes from, degrees.
inline constexpr Number lightAzimuth{.min = -360.0, .max = 360.0, .unit = "DEG"};
inline constexpr Number lightElevation{.min = -90.0, .max = 90.0, .unit = "DEG"};
/// Sides of pictures.
inline constexpr Count pictureSides{.min = 1, .max = PictureSettings::maxSide, .unit = "PX"};

[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

[[nodiscard]] double parseNumber(const Number&, std::string_view text);
[[nodiscard]] std::uint64_t parseCount(const Count&, std::string_view text);
/// @return  the index of the name in the list
[[nodiscard]] int parseChoice(std::span<const std::string_view> names, std::string_view text);
/// @return  the value as a number in text if it is no index of a name
[[nodiscard]] std::string nameOf(std::span<const std::string_view> names, int value);

[[nodiscard]] glm::dvec3 parseVector(std::string_view text);
/// An axis with its sign, "+Z", or a vector other than 0,0,0.
[[nodiscard]] glm::dvec3 parseDirection(std::string_view text);
[[nodiscard]] PictureExtent parseExtent(std::string_view text);
/// A margin: 0 or more, in pixels or millimetres.
[[nodiscard]] PictureLength parseMargin(std::string_view text);
/// The quotient of "1:2".
[[nodiscard]] double parseScale(std::string_view text);
[[nodiscard]] Color parseColor(std::string_view text);
[[nodiscard]] PictureLength parseLength(std::string_view text);
[[nodiscard]] PageSize parsePage(std::string_view text);
[[nodiscard]] LightDirection parseLight(std::string_view text);
[[nodiscard]] Isolines parseIsolines(std::string_view text);
/// What --line-style sets.
struct Pens {
    std::array<PenSettings, lineTypeCount> types;
    HiddenPenSettings hidden;
};
[[nodiscard]] Pens parsePens(std::string_view text);
[[nodiscard]] std::vector<FunctionSettings> parseFunctions(std::string_view text);

/// @throws Error  (Kind::Usage) as surfaceFunction() does; files may have any name
void checkFunctions(const std::vector<FunctionSettings>&);

[[nodiscard]] std::string textOf(double);
[[nodiscard]] std::string textOf(float);
[[nodiscard]] std::string textOf(int);
[[nodiscard]] std::string textOf(std::uint64_t);
[[nodiscard]] std::string textOf(const std::string&);
[[nodiscard]] std::string textOf(const std::filesystem::path&);
[[nodiscard]] std::string textOf(glm::dvec3);
[[nodiscard]] std::string textOf(Size);
[[nodiscard]] std::string textOf(const PictureExtent&);
[[nodiscard]] std::string textOf(Color);
[[nodiscard]] std::string textOf(const PictureLength&);
[[nodiscard]] std::string textOf(const PageSize&);
[[nodiscard]] std::string textOf(LightDirection);
[[nodiscard]] std::string textOf(const Isolines&);
[[nodiscard]] std::string textOf(const Pens&);
/// "+Z", or numbers where it is no axis.
[[nodiscard]] std::string textOfDirection(glm::dvec3);
/// "1:2", or "2:1" where it magnifies.
[[nodiscard]] std::string textOfScale(double);
[[nodiscard]] std::string textOf(const std::vector<FunctionSettings>&);
template <class T>
[[nodiscard]] std::string textOf(const std::optional<T>& value) {
    return value ? textOf(*value) : std::string{};
}

}  // namespace inkedge::settings
