#include <inkedge/compare.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <inkedge/error.h>
#include <inkedge/write.h>

#include "base/file_key.h"
#include "base/staged_files.h"
#include "images/image_formats.h"
#include "io/output_formats.h"
#include "io/picture.h"
#include "io/read_picture.h"

namespace fs = std::filesystem;

namespace inkedge {
namespace {

/// An 8-bit level n / 255 is not exact in float: the error of a difference of two such levels is under this.
constexpr double integerRounding = 1e-6;

std::string shape(const Image<float>& image) {
    return fmt::format("{} x {} pixels of {} channel{}", image.size().width, image.size().height, image.channels(),
                       image.channels() == 1 ? "" : "s");
}

void expectSameShape(const fs::path& a, const Image<float>& left, const fs::path& b, const Image<float>& right) {
    if (left.size() == right.size() && left.channels() == right.channels()) return;
    throw Error{Error::Kind::Input,
                fmt::format("{}: expected {}, as {} has, found {}", b.string(), shape(left), a.string(), shape(right))};
}

/// The largest difference over the channels of a pixel; infinite if one value is NaN or an infinity and the other not.
float pixelDifference(const Image<float>& a, const Image<float>& b, int x, int y) {
    float largest = 0.0F;
    for (int c = 0; c < a.channels(); ++c) {
        const float left = a(x, y, c);
        const float right = b(x, y, c);
        if (left == right || (std::isnan(left) && std::isnan(right))) continue;
        const float difference = std::abs(left - right);
        largest = std::isnan(difference) ? INFINITY : std::max(largest, difference);
    }
    return largest;
}

/// The differences as grey, as shares of the largest finite difference; infinite differences are white.
Image<std::uint8_t> differencePicture(const Image<float>& a, const Image<float>& b) {
    Image<float> differences{a.size(), 1};
    float largest = 0.0F;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            const float difference = differences(x, y) = pixelDifference(a, b, x, y);
            if (std::isfinite(difference)) largest = std::max(largest, difference);
        }
    }
    Image<std::uint8_t> picture{a.size(), 1};
    std::transform(differences.pixels().begin(), differences.pixels().end(), picture.mutablePixels().begin(),
                   [&](float value) {
                       if (value == 0.0F) return std::uint8_t{0};
                       return std::isfinite(value) ? static_cast<std::uint8_t>(std::lround(255.0F * (value / largest)))
                                                   : std::uint8_t{255};
                   });
    return picture;
}

/// Takes the pixels whose difference is infinite out of both pictures, by making them alike: OpenImageIO takes one for
/// the largest difference of the pictures, but counts it in no pixel.
images::Differences takeOutInfiniteDifferences(Image<float>& a, Image<float>& b) {
    images::Differences taken;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            if (std::isfinite(pixelDifference(a, b, x, y))) continue;
            if (taken.pixelsOverLevel++ == 0) {
                taken.maximum = INFINITY;
                taken.maximumX = x;
                taken.maximumY = y;
            }
            for (int c = 0; c < a.channels(); ++c) a(x, y, c) = b(x, y, c) = 0.0F;
        }
    }
    return taken;
}

/// The differences of two pictures, which are changed.
images::Differences measure(Image<float>& a, Image<float>& b, double level) {
    const images::Differences infinite = takeOutInfiniteDifferences(a, b);
    images::Differences all = images::imageFormats(Error::Kind::Input).compare(a, b, level);
    all.pixelsOverLevel += infinite.pixelsOverLevel;
    if (infinite.pixelsOverLevel > 0) {
        all.maximum = infinite.maximum;
        all.maximumX = infinite.maximumX;
        all.maximumY = infinite.maximumY;
    }
    return all;
}

Comparison judge(const images::Differences& found, const Image<float>& image, const Tolerance& tolerance,
                 double rounding) {
    Comparison result{.size = image.size(),
                      .channels = image.channels(),
                      .pixelsOverLevel = found.pixelsOverLevel,
                      .maximum = found.maximum,
                      .mean = found.mean};
    const double pixels = static_cast<double>(image.size().width) * image.size().height;
    result.shareOverLevel = static_cast<double>(found.pixelsOverLevel) / pixels;
    result.maximumX = found.maximumX;
    result.maximumY = found.maximumY;
    result.same = result.shareOverLevel <= tolerance.share &&
                  result.maximum <= std::max(tolerance.level, tolerance.hardLimit) + rounding;
    return result;
}

// Refuses a name for the differences before the work.
void expectUsable(const fs::path& difference, const fs::path& a, const fs::path& b) {
    (void)io::pictureFormat(difference);
    for (const fs::path& picture : {a, b}) {
        if (base::fileKey(difference) != base::fileKey(picture)) continue;
        throw Error{Error::Kind::Usage,
                    fmt::format("{}: expected an output other than what is compared, found {}; choose another name",
                                difference.string(), picture.string())};
    }
}

// Differences of integers are shares of the largest one: a level over 1 lets everything pass.
void expectLevelOfShares(const images::ReadPicture& a, const images::ReadPicture& b, const Tolerance& tolerance) {
    if (!a.integers || !b.integers || tolerance.level <= 1.0) return;
    throw Error{Error::Kind::Usage,
                fmt::format("--level: expected 0 to 1 (1 is white over black), found {}", tolerance.level)};
}

}  // namespace

Comparison compare(const fs::path& a, const fs::path& b, const Tolerance& tolerance,
                   const std::optional<fs::path>& difference) {
    if (difference) expectUsable(*difference, a, b);
    images::ReadPicture left = io::readPicture(a);
    images::ReadPicture right = io::readPicture(b);
    expectSameShape(a, left.image, b, right.image);
    expectLevelOfShares(left, right, tolerance);

    const double rounding = left.integers && right.integers ? integerRounding : 0.0;
    std::vector<std::uint8_t> picture;
    if (difference) picture = io::encodePicture(differencePicture(left.image, right.image), *difference);
    const images::Differences found = measure(left.image, right.image, tolerance.level + rounding);
    if (!found.failure.empty()) {
        throw Error{Error::Kind::Runtime,
                    fmt::format("{}: expected it to be comparable to {}, found: {}; use a smaller picture", b.string(),
                                a.string(), found.failure)};
    }
    if (difference) writeFile(*difference, picture);
    return judge(found, left.image, tolerance, rounding);
}

}  // namespace inkedge
