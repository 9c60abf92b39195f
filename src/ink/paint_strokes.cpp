#include "ink/paint_strokes.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge {
namespace {

constexpr float halfDiagonal = 0.70711F;  // of a pixel
constexpr float leastOffset = 1e-4F;      // pixels: a shorter one has no direction worth the name

// The share of a pixel's square that lies on one side of a line: how far the line is from its centre, positive if the
// centre is on that side; how far the square reaches across the line, along its longer and its shorter axis.
float shareBeside(float distance, float longer, float shorter) {
    const float t = std::abs(distance);
    const float even = 0.5F * (longer - shorter);
    const float end = 0.5F * (longer + shorter);
    float far = 1.0F;
    if (t <= even) {
        far = 0.5F + t / longer;
    } else if (t < end) {
        far -= (end - t) * (end - t) / (2.0F * longer * shorter);
    }
    return distance < 0.0F ? 1.0F - far : far;
}

// The share of a pixel that a straight band covers: exact.
// @param normal    across the band, unit
// @param distance  of its centre line from the pixel's centre
float shareOfBand(glm::vec2 normal, float distance, float width) {
    const float outer = 0.5F * width + distance;
    const float inner = 0.5F * width - distance;
    if (inner >= halfDiagonal) return 1.0F;
    if (inner <= -halfDiagonal) return 0.0F;
    const glm::vec2 across = glm::abs(normal);
    const float longer = std::max(across.x, across.y);
    const float shorter = std::min(across.x, across.y);
    return shareBeside(inner, longer, shorter) + shareBeside(outer, longer, shorter) - 1.0F;
}

// Rows of a picture that are painted at once.
struct Rows {
    int first;
    int count;
};

// Some million pixels in floats, whatever the picture's size.
constexpr int pixelsAtOnce = 1 << 22;

std::vector<Rows> rowsOf(Size size) {
    const int count = std::max(1, pixelsAtOnce / size.width);
    std::vector<Rows> all;
    for (int y = 0; y < size.height; y += count) all.push_back({y, std::min(count, size.height - y)});
    return all;
}

// How far from its centre line a stroke covers pixels' centres.
float reachOf(float width) { return 0.5F * width + halfDiagonal; }

// Raises coverage to that of a stroke: a band of the pen's width around its centre line, with round caps.
// @param firstRow  of the picture that coverage shows
void cover(Image<float>& coverage, int firstRow, const Stroke& stroke, float width) {
    const float reach = reachOf(width);
    const glm::vec2 low = glm::min(stroke.from, stroke.to) - reach - 0.5F;
    const glm::vec2 high = glm::max(stroke.from, stroke.to) + reach - 0.5F;
    const int x0 = std::max(0, static_cast<int>(std::ceil(low.x)));
    const int y0 = std::max(firstRow, static_cast<int>(std::ceil(low.y)));
    const int x1 = std::min(coverage.size.width - 1, static_cast<int>(std::floor(high.x)));
    const int y1 = std::min(firstRow + coverage.size.height - 1, static_cast<int>(std::floor(high.y)));

    const glm::vec2 along = stroke.to - stroke.from;
    const float lengthSquared = glm::dot(along, along);
    const glm::vec2 perLength = lengthSquared > 0.0F ? along / lengthSquared : glm::vec2{0.0F};
    const glm::vec2 normal =
        lengthSquared > 0.0F ? glm::vec2{-along.y, along.x} / std::sqrt(lengthSquared) : glm::vec2{1, 0};
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const glm::vec2 p = glm::vec2{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F} - stroke.from;
            const float s = glm::dot(p, perLength);
            const glm::vec2 offset = p - std::clamp(s, 0.0F, 1.0F) * along;
            const float distance = glm::length(offset);
            if (distance >= reach) continue;
            const bool beside = (s > 0.0F && s < 1.0F) || distance < leastOffset;  // not at a cap
            float& to = coverage.at(x, y - firstRow);
            to = std::max(
                to, beside ? shareOfBand(normal, distance, width) : shareOfBand(offset / distance, distance, width));
        }
    }
}

// Lays a colour over a picture as far as it covers.
void blend(Image<float>& picture, const Image<float>& coverage, Color color) {
    const float channels[3]{static_cast<float>(color.red), static_cast<float>(color.green),
                            static_cast<float>(color.blue)};
    for (std::size_t i = 0; i < coverage.pixels.size(); ++i) {
        const float c = coverage.pixels[i];
        if (c == 0.0F) continue;
        float* pixel = &picture.pixels[i * static_cast<std::size_t>(picture.channels)];
        if (picture.channels == 4) {  // straight alpha: the colour is that of the ink alone
            const float alpha = c + pixel[3] / 255.0F * (1.0F - c);
            for (int k = 0; k < 3; ++k) pixel[k] += (channels[k] - pixel[k]) * c / alpha;
            pixel[3] = 255.0F * alpha;
        } else {
            for (int k = 0; k < picture.channels; ++k) pixel[k] += (channels[k] - pixel[k]) * c;
        }
    }
}

// Pens of one colour, which are laid on together.
struct Coat {
    Color color;
    std::bitset<penCount> pens;
};

// What covers comes later: of each colour where its first line type stands, those of hidden lines before all others.
std::vector<Coat> coatsOf(const std::array<Pen, penCount>& all) {
    std::vector<Coat> coats;
    const auto addPens = [&](std::size_t first) {
        std::vector<Coat> added;
        for (std::size_t i = first + lineTypeCount; i-- > first;) {
            const auto same = std::ranges::find(added, all[i].color, &Coat::color);
            Coat coat = same == added.end() ? Coat{all[i].color, {}} : *same;
            if (same != added.end()) added.erase(same);
            coat.pens.set(i);
            added.push_back(coat);
        }
        // A colour that goes on is one coat, so that what is hidden joins what is seen.
        if (!coats.empty() && coats.back().color == added.front().color) {
            coats.back().pens |= added.front().pens;
            added.erase(added.begin());
        }
        coats.insert(coats.end(), added.begin(), added.end());
    };
    addPens(lineTypeCount);
    addPens(0);
    return coats;
}

Image<float> emptyPicture(const PictureSettings& settings, Size size, bool grey) {
    const Color behind = settings.background.value_or(settings.lineColor);
    if (grey) return {size, 1, static_cast<float>(behind.red)};
    Image<float> picture{size, settings.background ? 3 : 4, 0.0F};
    const float channels[3]{static_cast<float>(behind.red), static_cast<float>(behind.green),
                            static_cast<float>(behind.blue)};
    for (std::size_t i = 0; i < picture.pixels.size(); i += static_cast<std::size_t>(picture.channels)) {
        std::copy_n(channels, 3, picture.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return picture;
}

using Pens = std::array<Pen, penCount>;

// The strokes that reach into each part of the picture.
std::vector<std::vector<Stroke>> sorted(std::span<const Stroke> strokes, const std::vector<Rows>& parts,
                                        const Pens& allPens) {
    std::vector<std::vector<Stroke>> each(parts.size());
    const auto last = static_cast<float>(parts.size() - 1);
    const auto partOf = [&](float y) {
        return static_cast<std::size_t>(std::clamp(std::floor(y / static_cast<float>(parts[0].count)), 0.0F, last));
    };
    for (const Stroke& stroke : strokes) {
        const float reach = reachOf(static_cast<float>(allPens[stroke.style].width)) + 1.0F;
        const std::size_t end = partOf(std::max(stroke.from.y, stroke.to.y) + reach);
        for (std::size_t i = partOf(std::min(stroke.from.y, stroke.to.y) - reach); i <= end; ++i) {
            each[i].push_back(stroke);
        }
    }
    return each;
}

// Lays one colour after the other over the background.
Image<float> paintRows(Rows rows, std::span<const Stroke> strokes, const Pens& allPens,
                       const std::vector<Coat>& coats, const PictureSettings& settings, bool grey) {
    const Size size{settings.size.width, rows.count};
    Image<float> picture = emptyPicture(settings, size, grey);
    for (const Coat& coat : coats) {
        const auto isOfCoat = [&](const Stroke& stroke) { return coat.pens.test(stroke.style); };
        if (std::ranges::none_of(strokes, isOfCoat)) continue;
        Image<float> coverage{size, 1, 0.0F};
        for (const Stroke& stroke : strokes) {
            if (!isOfCoat(stroke)) continue;
            cover(coverage, rows.first, stroke, static_cast<float>(allPens[stroke.style].width));
        }
        blend(picture, coverage, coat.color);
    }
    return picture;
}

}  // namespace

Image<std::uint8_t> paintStrokes(std::span<const Stroke> strokes, const PictureSettings& settings) {
    const auto allPens = pens(settings);
    const bool grey = settings.background && settings.background->grey() &&
                      std::ranges::all_of(allPens, [](const Pen& pen) { return pen.color.grey(); });
    const std::vector<Coat> coats = coatsOf(allPens);
    const std::vector<Rows> parts = rowsOf(settings.size);
    const std::vector<std::vector<Stroke>> strokesOf = sorted(strokes, parts, allPens);
    Image<std::uint8_t> result{settings.size, grey ? 1 : settings.background ? 3 : 4};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Image<float> picture = paintRows(parts[i], strokesOf[i], allPens, coats, settings, grey);
        std::ranges::transform(picture.pixels, &result.at(0, parts[i].first),
                               [](float v) { return static_cast<std::uint8_t>(std::lround(v)); });
    }
    return result;
}

}  // namespace inkedge
