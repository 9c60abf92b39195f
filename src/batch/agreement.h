#pragma once

#include <inkedge/lines.h>

namespace inkedge::batch {

/// How far lines between pixels and lines of the mesh agree: pixels of lines within the picture.
struct Agreement {
    double image = 0.0;       ///< of lines from image space
    double imageNear = 0.0;   ///< of these, as near to a line from object space as agreementReach
    double object = 0.0;      ///< of lines from object space that are seen
    double objectNear = 0.0;  ///< of these, as near to a line from image space

    /// Share of the lines from image space that the mesh has, 1 where there are none.
    [[nodiscard]] double precision() const noexcept { return image > 0.0 ? imageNear / image : 1.0; }
    /// Share of the lines of the mesh that image space finds.
    [[nodiscard]] double recall() const noexcept { return object > 0.0 ? objectNear / object : 1.0; }
    /// Their harmonic mean.
    [[nodiscard]] double f1() const noexcept;

    Agreement& operator+=(const Agreement&) noexcept;
};
inline constexpr double agreementReach = 1.5;  ///< pixels

/// @param image   of LinesFrom::Image
/// @param object  of LinesFrom::Object, of the same view
[[nodiscard]] Agreement agreementOf(const Lines& image, const Lines& object);

}  // namespace inkedge::batch
