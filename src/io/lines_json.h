#pragma once

#include <array>
#include <string_view>

#include <inkedge/lines.h>

/// What linesJson() and linesFromJson() agree on.
namespace inkedge::io {

inline constexpr std::string_view linesFormat = "inkedge lines";
inline constexpr int linesVersion = 3;

/// In the order of LengthUnit.
inline constexpr std::array<std::string_view, 6> lengthUnitNames{"unknown",    "metre", "millimetre",
                                                                 "centimetre", "inch",  "foot"};
/// Where lines were found: LinesFrom::Object, LinesFrom::Image.
inline constexpr std::array<std::string_view, 2> spaceNames{"object", "image"};

/// Whether all that is written of a camera is finite.
[[nodiscard]] bool isFinite(const Camera&, Size) noexcept;

}  // namespace inkedge::io
