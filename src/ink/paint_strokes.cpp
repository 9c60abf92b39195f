#include "ink/paint_strokes.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "base/stop.h"
#include "ink/brushed_strokes.h"
#include "ink/stroke_coverage.h"
#include "settings/pens.h"

namespace inkedge::ink {
namespace {

// Rows that are painted together: few enough to stay in the processor's cache while strokes are painted.
constexpr int stripRows = 16;

struct Strip {
    Rows rows;
    Image<float> picture;
    Image<float> coverage;
};

// Paints a colour over a picture by its coverage.
void blend(Strip& strip, Color color) {
    const float channels[3]{static_cast<float>(color.red), static_cast<float>(color.green),
                            static_cast<float>(color.blue)};
    const auto count = static_cast<std::size_t>(strip.picture.channels());
    float* pixel = strip.picture.mutablePixels().data();
    if (count == 1) {
        for (const float c : strip.coverage.pixels()) {
            *pixel += (channels[0] - *pixel) * c;
            ++pixel;
        }
        return;
    }
    for (const float c : strip.coverage.pixels()) {
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

// Pens of one colour, which are painted together.
struct Coat {
    Color color;
    std::bitset<settings::penCount> pens;
};

// Coats in the order in which they are painted. Hidden lines come before visible ones; among these the coat whose first
// line type comes first in LineType is painted last.
std::vector<Coat> coatsOf(const std::array<settings::Pen, settings::penCount>& all) {
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
        // The last coat of hidden lines and the first of visible ones are one if they have one colour, so that they
        // join.
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

Image<std::uint8_t> emptyPicture(const PictureSettings& settings, settings::Paper paper) {
    const Color behind = settings::colorOf(paper, settings).value_or(settings.lineColor);
    const int channelCount = settings::pictureChannels(settings, paper);
    if (channelCount == 1) return {settings.size, 1, behind.red};
    Image<std::uint8_t> picture{settings.size, channelCount};
    const std::uint8_t channels[3]{behind.red, behind.green, behind.blue};
    for (std::size_t i = 0; i < picture.pixels().size(); i += static_cast<std::size_t>(picture.channels())) {
        std::copy_n(channels, 3, picture.mutablePixels().begin() + static_cast<std::ptrdiff_t>(i));
    }
    return picture;
}

using Pens = std::array<settings::Pen, settings::penCount>;

// The strokes that each strip shows, in their order.
std::vector<std::vector<BoxedStroke>> sorted(std::span<const Stroke> strokes, const Pens& allPens, Size size) {
    std::vector<std::vector<BoxedStroke>> strips(static_cast<std::size_t>((size.height + stripRows - 1) / stripRows));
    for (const Stroke& stroke : strokes) {
        const auto width = static_cast<float>(allPens[stroke.pen].width);
        const BoxedStroke shown = boxed(stroke, width, size);
        if (shown.box.x0 > shown.box.x1) continue;
        for (int y = shown.box.y0; y <= shown.box.y1; y = (y / stripRows + 1) * stripRows)
            strips[static_cast<std::size_t>(y / stripRows)].push_back(shown);
    }
    return strips;
}

void coverPlain(Strip& strip, std::span<const BoxedStroke> strokes, const Coat& coat) {
    for (const BoxedStroke& s : strokes)
        if (coat.pens.test(s.stroke->pen)) cover(strip.coverage, strip.rows, s);
}

// Paints strokes over the part of a picture that a strip covers.
void paint(Strip& strip, std::span<const BoxedStroke> strokes, std::span<const Coat> coats,
           Image<std::uint8_t>& picture, std::optional<BrushedStrokes>& brushed) {
    const auto begin = &picture(0, strip.rows.first);
    const int rows = std::min(stripRows, picture.size().height - strip.rows.first);
    const std::ptrdiff_t values = std::ptrdiff_t{rows} * picture.size().width * picture.channels();
    std::copy_n(begin, values, strip.picture.mutablePixels().begin());
    for (const Coat& coat : coats) {
        const auto isOfCoat = [&](const BoxedStroke& s) { return coat.pens.test(s.stroke->pen); };
        if (std::ranges::none_of(strokes, isOfCoat)) continue;
        std::ranges::fill(strip.coverage.mutablePixels(), 0.0F);
        if (brushed) {
            brushed->cover(strip.coverage, strip.rows, strokes, coat.pens);
        } else {
            coverPlain(strip, strokes, coat);
        }
        blend(strip, coat.color);
    }
    constexpr auto rounded = [](float v) { return static_cast<std::uint8_t>(static_cast<int>(double{v} + 0.5)); };
    std::transform(strip.picture.pixels().begin(), strip.picture.pixels().begin() + values, begin, rounded);
}

}  // namespace

Image<std::uint8_t> paintStrokes(std::span<const Stroke> strokes, const PictureSettings& settings, const Brush* brush,
                                 settings::Paper paper) {
    const auto allPens = settings::pens(settings);
    const std::vector<Coat> coats = coatsOf(allPens);
    Image<std::uint8_t> picture = emptyPicture(settings, paper);
    const Size stripSize{settings.size.width, stripRows};
    Strip strip{{0, stripRows}, {stripSize, picture.channels()}, {stripSize, 1}};
    std::optional<BrushedStrokes> brushed;
    if (brush != nullptr) brushed.emplace(*brush, strokes, allPens, stripSize);
    for (const std::vector<BoxedStroke>& shown : sorted(strokes, allPens, settings.size)) {
        base::stopIfAsked();
        if (!shown.empty()) paint(strip, shown, coats, picture, brushed);
        strip.rows.first += stripRows;
    }
    return picture;
}

}  // namespace inkedge::ink
