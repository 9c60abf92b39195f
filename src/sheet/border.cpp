#include "sheet/border.h"

#include <cmath>
#include <string>

#include "sheet/ink.h"
#include "sheet/page.h"

namespace inkedge::sheet {
namespace {

constexpr double frameWidth = 0.7;
constexpr double fieldWidth = 0.35;   // of the marks between fields
constexpr double fieldLength = 50.0;  // counted from the middle; those in the corners take the rest
constexpr double fieldDepth = 5.0;    // of the strip outside the frame
constexpr double markLength = 5.0;    // of a centring mark, inside the frame
constexpr double letterHeight = 3.5;
constexpr int smallest = 4;  // A4 has fields above and on the right alone

// Fields along one axis of the page.
struct Fields {
    double low;  // of the frame
    double high;
    double middle;  // of the page
    int count;      // even

    // Where field i begins; i = count: where the last one ends.
    [[nodiscard]] double begin(int i) const {
        if (i == 0) return low;
        return i == count ? high : middle + (i - count / 2) * fieldLength;
    }
    [[nodiscard]] double middleOf(int i) const { return 0.5 * (begin(i) + begin(i + 1)); }
};

Fields fieldsOf(double low, double high, double length) {
    return {low, high, 0.5 * length, 2 * static_cast<int>(std::lround(0.5 * length / fieldLength))};
}

// A, B, C, ..., without I and O, which look like digits.
std::string letterOf(int i) {
    constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
    return std::string{letters[static_cast<std::size_t>(i)]};
}

}  // namespace

io::Layer borderLayer(const SheetPage& page) {
    Ink ink{"frame", frameWidth};
    const glm::dvec2 size = sizeOf(page);
    const Rect frame = framed(page);
    const Rect block = titleBlock(page);
    ink.rectangle(frame, frameWidth);
    const Fields across = fieldsOf(frame.low.x, frame.high.x, size.x);
    const Fields down = fieldsOf(frame.low.y, frame.high.y, size.y);
    // From the frame outwards; centring marks reach inwards, too, where nothing is written.
    const auto marks = [&](const Fields& fields, auto line) {
        for (int i = 1; i < fields.count; ++i)
            if (2 * i != fields.count) line(fields.begin(i), 0.0, fieldWidth);
        line(fields.middle, markLength, frameWidth);
    };
    const bool isSmall = page.series == smallest;
    marks(across, [&](double x, double inwards, double width) {
        const bool isBlock = x > block.low.x && x < block.high.x;
        ink.line({x, frame.low.y - fieldDepth}, {x, frame.low.y + inwards}, width);
        if (!isSmall || inwards > 0.0)
            ink.line({x, frame.high.y - (isBlock ? 0.0 : inwards)}, {x, frame.high.y + fieldDepth}, width);
    });
    marks(down, [&](double y, double inwards, double width) {
        ink.line({frame.high.x - inwards, y}, {frame.high.x + fieldDepth, y}, width);
        if (!isSmall || inwards > 0.0) ink.line({frame.low.x - fieldDepth, y}, {frame.low.x + inwards, y}, width);
    });
    const double off = 0.5 * fieldDepth;
    for (int i = 0; i < across.count; ++i) {
        const std::string name = std::to_string(i + 1);
        ink.textAround(name, {across.middleOf(i), frame.low.y - off}, letterHeight);
        if (!isSmall) ink.textAround(name, {across.middleOf(i), frame.high.y + off}, letterHeight);
    }
    for (int i = 0; i < down.count; ++i) {
        ink.textAround(letterOf(i), {frame.high.x + off, down.middleOf(i)}, letterHeight);
        if (!isSmall) ink.textAround(letterOf(i), {frame.low.x - off, down.middleOf(i)}, letterHeight);
    }
    return std::move(ink).take();
}

}  // namespace inkedge::sheet
