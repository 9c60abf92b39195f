#pragma once

#include <string_view>

namespace inkedge::polygons {

/// The formats that loadPolygons() reads.
enum class PolygonFormat { Obj, Stl, Ply };

/// Whether texture coordinates are needed.
enum class Coordinates { Skip, Read };

[[nodiscard]] constexpr std::string_view name(PolygonFormat format) noexcept {
    switch (format) {
        case PolygonFormat::Obj:
            return "OBJ";
        case PolygonFormat::Stl:
            return "STL";
        case PolygonFormat::Ply:
            return "PLY";
    }
    return "";
}

}  // namespace inkedge::polygons
