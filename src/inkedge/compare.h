#pragma once

#include <filesystem>
#include <optional>

#include <inkedge/export.h>
#include <inkedge/image.h>

namespace inkedge {

/// When two pictures count as the same. A pixel's difference is its largest over the channels; values run from 0 to 1
/// in 8-bit pictures and are taken as they are in float ones. NaN is as NaN, and differs from every number by infinity.
struct Tolerance {
    double level = 0.0;  ///< differences up to this are not counted
    double share = 0.0;  ///< the share of pixels, 0..1, that may lie over the level
    /// No pixel may differ by more than this, those within the share included. What lies under level counts as level.
    double hardLimit = 0.0;
};

struct Comparison {
    Size size;
    int channels = 0;
    std::uint64_t pixelsOverLevel = 0;
    double shareOverLevel = 0.0;
    double maximum = 0.0;  ///< largest difference, and where it is
    int maximumX = 0;
    int maximumY = 0;
    double mean = 0.0;  ///< mean difference over pixels and channels, without pixels whose difference is infinite
    bool same = false;  ///< within the tolerance
};

/// Compares two pictures of any format that OpenImageIO reads.
/// @param differencePicture  where to write the absolute difference, brightened so that the largest is white; written
///                           whether they differ or not
/// @throws Error  (Kind::Input) if a file cannot be read, or if sizes or channel counts differ: the message gives both;
///                (Kind::Usage) if both files hold integers, which are read as 0..1, and the level is over 1;
///                (Kind::Output) if the difference picture cannot be written
[[nodiscard]] INKEDGE_API Comparison compare(const std::filesystem::path& a, const std::filesystem::path& b,
                                             const Tolerance& tolerance,
                                             const std::optional<std::filesystem::path>& differencePicture = {});

}  // namespace inkedge
