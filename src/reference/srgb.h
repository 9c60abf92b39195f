#pragma once

#include <cmath>

namespace inkedge::reference {

/// A linear part of a colour as sRGB's, and back: both 0 to 1 (IEC 61966-2-1).
inline double toSrgb(double c) { return c > 0.0031308 ? 1.055 * std::pow(c, 1.0 / 2.4) - 0.055 : 12.92 * c; }
inline double toLinear(double c) { return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92; }

}  // namespace inkedge::reference
