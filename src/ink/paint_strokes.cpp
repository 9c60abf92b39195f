#include "ink/paint_strokes.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "settings/picture_channels.h"

namespace inkedge {
namespace {

constexpr float halfDiagonal = 0.70711F;  // of a pixel
constexpr float leastOffset = 1e-4F;      // pixels: a shorter one has no direction worth the name

// A band's direction, as far as the share of a pixel's square that it covers depends on it.
class BandShare {
public:
    /// @param normal  across the band, unit
    BandShare(glm::vec2 normal, float width) : halfWidth_{0.5F * width} {
        const glm::vec2 across = glm::abs(normal);
        longer_ = std::max(across.x, across.y);
        const float shorter = std::min(across.x, across.y);
        even_ = 0.5F * (longer_ - shorter);
        end_ = 0.5F * (longer_ + shorter);
        corner_ = 2.0F * longer_ * shorter;
    }

    /// Exact.
    /// @param distance  of the band's centre line from the pixel's centre
    [[nodiscard]] float at(float distance) const {
        const float outer = halfWidth_ + distance;
        const float inner = halfWidth_ - distance;
        if (inner >= halfDiagonal) return 1.0F;
        if (inner <= -halfDiagonal) return 0.0F;
        return beside(inner) + beside(outer) - 1.0F;
    }

private:
    // The share that lies on one side of a line: how far it is from the centre, positive if the centre is on that side.
    [[nodiscard]] float beside(float distance) const {
        const float t = std::abs(distance);
        float far = 1.0F;
        if (t <= even_) {
            far = 0.5F + t / longer_;
        } else if (t < end_) {
            far -= (end_ - t) * (end_ - t) / corner_;
        }
        return distance < 0.0F ? 1.0F - far : far;
    }

    float halfWidth_;
    float longer_;  // how far the square reaches across, along its longer axis
    float even_;    // up to here a line cuts two opposite sides
    float end_;     // from here on it cuts none
    float corner_;
};

// Pixels from (x0, y0) to (x1, y1); none if it ends before it begins.
struct Box {
    int x0;
    int y0;
    int x1;
    int y1;
};

// The pixels of a picture that a stroke may cover.
Box boxOf(const Stroke& stroke, float width, Size size) {
    const float reach = 0.5F * width + halfDiagonal;
    const glm::vec2 low = glm::min(stroke.from, stroke.to) - reach - 0.5F;
    const glm::vec2 high = glm::max(stroke.from, stroke.to) + reach - 0.5F;
    return {std::max(0, static_cast<int>(std::ceil(low.x))), std::max(0, static_cast<int>(std::ceil(low.y))),
            std::min(size.width - 1, static_cast<int>(std::floor(high.x))),
            std::min(size.height - 1, static_cast<int>(std::floor(high.y)))};
}

// Some rows of the picture, small enough to stay in the processor's cache while strokes are laid over each other.
constexpr int stripRows = 16;

struct Strip {
    int firstRow;
    Image<float> picture;
    Image<float> coverage;
};

// Raises coverage to that of a stroke: a band of the pen's width around its centre line, with round caps.
// @param box  its pixels
void cover(Strip& strip, const Stroke& stroke, float width, Box box) {
    const float reach = 0.5F * width + halfDiagonal;
    const glm::vec2 along = stroke.to - stroke.from;
    const float lengthSquared = glm::dot(along, along);
    const glm::vec2 perLength = lengthSquared > 0.0F ? along / lengthSquared : glm::vec2{0.0F};
    const glm::vec2 normal =
        lengthSquared > 0.0F ? glm::vec2{-along.y, along.x} / std::sqrt(lengthSquared) : glm::vec2{1, 0};
    const BandShare band{normal, width};
    const int y1 = std::min(box.y1, strip.firstRow + stripRows - 1);
    for (int y = std::max(box.y0, strip.firstRow); y <= y1; ++y) {
        float* const row = &strip.coverage.at(0, y - strip.firstRow);
        for (int x = box.x0; x <= box.x1; ++x) {
            const glm::vec2 p = glm::vec2{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F} - stroke.from;
            const float s = glm::dot(p, perLength);
            const glm::vec2 offset = p - std::clamp(s, 0.0F, 1.0F) * along;
            const float distanceSquared = glm::dot(offset, offset);
            if (distanceSquared >= reach * reach || row[x] >= 1.0F) continue;
            const float distance = std::sqrt(distanceSquared);
            const bool beside = (s > 0.0F && s < 1.0F) || distance < leastOffset;  // not at a cap
            row[x] = std::max(row[x], beside ? band.at(distance) : BandShare{offset / distance, width}.at(distance));
        }
    }
}

// Of a pen's width, at each end.
struct EndWidths {
    float from;
    float to;
};
EndWidths widthsOf(const Stroke& stroke, float penWidth) {
    return {penWidth * static_cast<float>(stroke.widthFrom) / fullWidth,
            penWidth * static_cast<float>(stroke.widthTo) / fullWidth};
}

bool varies(const Stroke& stroke) { return stroke.widthFrom != fullWidth || stroke.widthTo != fullWidth; }

// The same for a stroke whose width changes along it.
void coverVarying(Strip& strip, const Stroke& stroke, float penWidth, Box box) {
    const auto [first, last] = widthsOf(stroke, penWidth);
    const float reach = 0.5F * std::max(first, last) + halfDiagonal;
    const glm::vec2 along = stroke.to - stroke.from;
    const float lengthSquared = glm::dot(along, along);
    const glm::vec2 perLength = lengthSquared > 0.0F ? along / lengthSquared : glm::vec2{0.0F};
    const glm::vec2 normal =
        lengthSquared > 0.0F ? glm::vec2{-along.y, along.x} / std::sqrt(lengthSquared) : glm::vec2{1, 0};
    const int y1 = std::min(box.y1, strip.firstRow + stripRows - 1);
    for (int y = std::max(box.y0, strip.firstRow); y <= y1; ++y) {
        float* const row = &strip.coverage.at(0, y - strip.firstRow);
        for (int x = box.x0; x <= box.x1; ++x) {
            const glm::vec2 p = glm::vec2{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F} - stroke.from;
            const float s = std::clamp(glm::dot(p, perLength), 0.0F, 1.0F);
            const glm::vec2 offset = p - s * along;
            const float distance = glm::length(offset);
            if (distance >= reach) continue;
            const bool beside = (s > 0.0F && s < 1.0F) || distance < leastOffset;
            const glm::vec2 across = beside ? normal : offset / distance;
            row[x] = std::max(row[x], BandShare{across, glm::mix(first, last, s)}.at(distance));
        }
    }
}

// What the brush needs to know of a stroke besides: which line's it is, and whether its ends are that line's or a
// dash's, beyond which the brush goes straight on; around the others it turns.
struct PlaceInLine {
    std::uint32_t line;
    bool opensFrom;
    bool opensTo;
    float around;  // pixels of way around a closed line; of an open one 0
};

struct BoxedStroke {
    const Stroke* stroke;
    float width;  // of its pen
    Box box;
};

// One line of a strip, before it meets the others: how far its nearest stroke is from each pixel, and what that one
// brings.
struct LineStrip {
    Image<float> coverage;
    Image<float> distance;
    Image<float> ink;
    void clear(Box box, int firstRow);
};

void LineStrip::clear(Box box, int firstRow) {
    for (int y = box.y0 - firstRow; y <= box.y1 - firstRow; ++y) {
        std::fill(&coverage.at(box.x0, y), &coverage.at(box.x1, y) + 1, 0.0F);
        std::fill(&distance.at(box.x0, y), &distance.at(box.x1, y) + 1, std::numeric_limits<float>::infinity());
    }
}

// Adds a stroke to its line.
// @param box  its pixels in the strip
void coverBrushed(LineStrip& line, int firstRow, const BoxedStroke& boxed, PlaceInLine place, const FittedBrush& brush,
                  Box box) {
    const Stroke& stroke = *boxed.stroke;
    const auto [first, last] = widthsOf(stroke, boxed.width);
    const float reach = 0.5F * std::max(first, last) + halfDiagonal;
    const glm::vec2 along = stroke.to - stroke.from;
    const float length = glm::length(along);
    const glm::vec2 direction = length > 0.0F ? along / length : glm::vec2{1, 0};
    const glm::vec2 normal{-direction.y, direction.x};
    const float stretch = brush.stretchAround(place.around);
    for (int y = box.y0; y <= box.y1; ++y) {
        for (int x = box.x0; x <= box.x1; ++x) {
            const glm::vec2 p = glm::vec2{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F} - stroke.from;
            const float way = glm::dot(p, direction);
            const float wayOnStroke = std::clamp(way, 0.0F, length);
            const glm::vec2 offset = p - wayOnStroke * direction;
            const float distance = glm::length(offset);
            if (distance >= reach) continue;
            const bool beside = (way > 0.0F && way < length) || distance < leastOffset;
            const glm::vec2 across = beside ? normal : offset / distance;
            const float width = length > 0.0F ? glm::mix(first, last, wayOnStroke / length) : first;
            float& coverage = line.coverage.at(x, y - firstRow);
            coverage = std::max(coverage, BandShare{across, width}.at(distance));
            float& nearest = line.distance.at(x, y - firstRow);
            if (distance >= nearest) continue;
            nearest = distance;
            const float side = glm::dot(p, normal);
            const bool beyond = (way < 0.0F && place.opensFrom) || (way > length && place.opensTo);
            line.ink.at(x, y - firstRow) =
                brush.inkAt(stretch * (stroke.arc + (beyond ? way : wayOnStroke)),
                            (beyond ? side : std::copysign(distance, side)) / std::max(width, leastOffset));
        }
    }
}

// A brush for each pen that draws strokes.
using Brushes = std::array<std::optional<FittedBrush>, penCount>;

// The pixels of a strip that strokes may cover.
Box boxIn(const Strip& strip, std::span<const BoxedStroke> strokes) {
    Box all = strokes.front().box;
    for (const BoxedStroke& s : strokes) {
        all = {std::min(all.x0, s.box.x0), std::min(all.y0, s.box.y0), std::max(all.x1, s.box.x1),
               std::max(all.y1, s.box.y1)};
    }
    return {all.x0, std::max(all.y0, strip.firstRow), all.x1, std::min(all.y1, strip.firstRow + stripRows - 1)};
}

// Lays a colour over a picture as far as it covers.
void blend(Strip& strip, Color color) {
    const float channels[3]{static_cast<float>(color.red), static_cast<float>(color.green),
                            static_cast<float>(color.blue)};
    const auto count = static_cast<std::size_t>(strip.picture.channels);
    float* pixel = strip.picture.pixels.data();
    if (count == 1) {
        for (const float c : strip.coverage.pixels) {
            *pixel += (channels[0] - *pixel) * c;
            ++pixel;
        }
        return;
    }
    for (const float c : strip.coverage.pixels) {
        if (c != 0.0F && count == 4) {  // straight alpha: the colour is that of the ink alone
            const float alpha = c + pixel[3] / 255.0F * (1.0F - c);
            for (int k = 0; k < 3; ++k) pixel[k] += (channels[k] - pixel[k]) * c / alpha;
            pixel[3] = 255.0F * alpha;
        } else if (c != 0.0F) {
            for (int k = 0; k < 3; ++k) pixel[k] += (channels[k] - pixel[k]) * c;
        }
        pixel += count;
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

Image<std::uint8_t> emptyPicture(const PictureSettings& settings) {
    const Color behind = settings.background.value_or(settings.lineColor);
    if (pictureChannels(settings) == 1) return {settings.size, 1, behind.red};
    Image<std::uint8_t> picture{settings.size, pictureChannels(settings)};
    const std::uint8_t channels[3]{behind.red, behind.green, behind.blue};
    for (std::size_t i = 0; i < picture.pixels.size(); i += static_cast<std::size_t>(picture.channels)) {
        std::copy_n(channels, 3, picture.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return picture;
}

using Pens = std::array<Pen, penCount>;

// Where each stroke stands in its line.
std::vector<PlaceInLine> placesIn(std::span<const Stroke> strokes) {
    std::vector<PlaceInLine> places(strokes.size());
    std::size_t begin = 0;  // of the line
    for (std::size_t end = 1; end <= strokes.size(); ++end) {
        if (end < strokes.size() && strokes[end].arc != 0.0F) continue;
        const std::size_t count = end - begin;
        const Stroke& last = strokes[end - 1];
        const bool closed = last.to == strokes[begin].from;
        const float around = closed ? last.arc + glm::distance(last.from, last.to) : 0.0F;
        for (std::size_t i = 0; i < count; ++i) {
            const Stroke& stroke = strokes[begin + i];
            const Stroke& before = strokes[begin + (i + count - 1) % count];  // of a closed line the last
            const Stroke& after = strokes[begin + (i + 1) % count];
            places[begin + i] = {static_cast<std::uint32_t>(begin), before.to != stroke.from, after.from != stroke.to,
                                 around};
        }
        begin = end;
    }
    return places;
}

// The strokes that each strip shows, in their order.
std::vector<std::vector<BoxedStroke>> sorted(std::span<const Stroke> strokes, const Pens& allPens, Size size) {
    std::vector<std::vector<BoxedStroke>> strips(static_cast<std::size_t>((size.height + stripRows - 1) / stripRows));
    for (const Stroke& stroke : strokes) {
        const auto width = static_cast<float>(allPens[stroke.style].width);
        const EndWidths ends = widthsOf(stroke, width);
        const Box box = boxOf(stroke, std::max(ends.from, ends.to), size);
        if (box.x0 > box.x1) continue;
        for (int y = box.y0; y <= box.y1; y = (y / stripRows + 1) * stripRows) {
            strips[static_cast<std::size_t>(y / stripRows)].push_back({&stroke, width, box});
        }
    }
    return strips;
}

// What draws with a brush.
struct BrushWork {
    std::span<const Stroke> strokes;
    std::vector<PlaceInLine> places;
    Brushes brushes;
    LineStrip line;
    [[nodiscard]] PlaceInLine placeOf(const BoxedStroke& boxed) const {
        return places[static_cast<std::size_t>(boxed.stroke - strokes.data())];
    }
};

BrushWork brushWork(const Brush& brush, std::span<const Stroke> strokes, const Pens& allPens, Size stripSize) {
    BrushWork work{strokes, placesIn(strokes), {}, {{stripSize, 1}, {stripSize, 1}, {stripSize, 1}}};
    for (const Stroke& stroke : strokes) {
        auto& fitted = work.brushes[stroke.style];
        if (fitted) continue;
        const double width = allPens[stroke.style].width;
        for (std::size_t other = 0; other < penCount && !fitted; ++other)
            if (work.brushes[other] && allPens[other].width == width) fitted = work.brushes[other];
        if (!fitted) fitted.emplace(brush, width);
    }
    return work;
}

// Raises coverage to that of one line's strokes, each pixel's times the brush's ink where the line is nearest to it.
void coverBrushed(Strip& strip, std::span<const BoxedStroke> strokes, BrushWork& work) {
    LineStrip& line = work.line;
    const Box all = boxIn(strip, strokes);
    line.clear(all, strip.firstRow);
    for (const BoxedStroke& s : strokes)
        coverBrushed(line, strip.firstRow, s, work.placeOf(s), *work.brushes[s.stroke->style], boxIn(strip, {&s, 1}));
    for (int y = all.y0 - strip.firstRow; y <= all.y1 - strip.firstRow; ++y) {
        for (int x = all.x0; x <= all.x1; ++x) {
            const float covered = line.coverage.at(x, y);
            float& coverage = strip.coverage.at(x, y);
            if (covered > 0.0F) coverage = std::max(coverage, covered * line.ink.at(x, y));
        }
    }
}

// Raises coverage to that of the strokes of a coat.
void coverBrushed(Strip& strip, std::span<const BoxedStroke> strokes, const Coat& coat, BrushWork& work) {
    for (std::size_t begin = 0; begin < strokes.size();) {
        std::size_t end = begin + 1;
        while (end < strokes.size() && work.placeOf(strokes[end]).line == work.placeOf(strokes[begin]).line) ++end;
        if (coat.pens.test(strokes[begin].stroke->style))
            coverBrushed(strip, strokes.subspan(begin, end - begin), work);
        begin = end;
    }
}

void coverPlain(Strip& strip, std::span<const BoxedStroke> strokes, const Coat& coat) {
    for (const BoxedStroke& s : strokes) {
        if (coat.pens.test(s.stroke->style))
            (varies(*s.stroke) ? coverVarying : cover)(strip, *s.stroke, s.width, s.box);
    }
}

// Paints strokes over the part of a picture that a strip covers.
void paint(Strip& strip, std::span<const BoxedStroke> strokes, std::span<const Coat> coats,
           Image<std::uint8_t>& picture, std::optional<BrushWork>& brush) {
    const auto begin = &picture.at(0, strip.firstRow);
    const int rows = std::min(stripRows, picture.size.height - strip.firstRow);
    const std::ptrdiff_t values = std::ptrdiff_t{rows} * picture.size.width * picture.channels;
    std::copy_n(begin, values, strip.picture.pixels.begin());
    for (const Coat& coat : coats) {
        const auto isOfCoat = [&](const BoxedStroke& s) { return coat.pens.test(s.stroke->style); };
        if (std::ranges::none_of(strokes, isOfCoat)) continue;
        std::ranges::fill(strip.coverage.pixels, 0.0F);
        if (brush) {
            coverBrushed(strip, strokes, coat, *brush);
        } else {
            coverPlain(strip, strokes, coat);
        }
        blend(strip, coat.color);
    }
    constexpr auto rounded = [](float v) { return static_cast<std::uint8_t>(static_cast<int>(double{v} + 0.5)); };
    std::transform(strip.picture.pixels.begin(), strip.picture.pixels.begin() + values, begin, rounded);
}

}  // namespace

Image<std::uint8_t> paintStrokes(std::span<const Stroke> strokes, const PictureSettings& settings, const Brush* brush) {
    const auto allPens = pens(settings);
    const std::vector<Coat> coats = coatsOf(allPens);
    Image<std::uint8_t> picture = emptyPicture(settings);
    const Size stripSize{settings.size.width, stripRows};
    Strip strip{0, {stripSize, picture.channels}, {stripSize, 1}};
    std::optional<BrushWork> work;
    if (brush != nullptr) work = brushWork(*brush, strokes, allPens, stripSize);
    for (const std::vector<BoxedStroke>& shown : sorted(strokes, allPens, settings.size)) {
        if (!shown.empty()) paint(strip, shown, coats, picture, work);
        strip.firstRow += stripRows;
    }
    return picture;
}

}  // namespace inkedge
