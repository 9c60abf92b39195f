#include "io/svg_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace inkedge::io {
namespace {

constexpr double largest = 1e9;  // pixels

// A number of hundredths as text: 150 is "1.5", -5 is "-.05".
std::string number(long long hundredths) {
    std::string text = hundredths < 0 ? "-" : "";
    const long long size = std::abs(hundredths);
    if (size >= 100 || size == 0) text += fmt::format("{}", size / 100);
    if (size % 100 != 0) text += fmt::format(".{:02}", size % 100);
    if (size % 100 != 0 && size % 10 == 0) text.pop_back();
    return text;
}

}  // namespace

SvgPath::Point SvgPath::rounded(glm::dvec2 p) const {
    const auto hundredths = [&](double v) {
        return std::llround(std::clamp(v, -largest, largest) * 100.0 / static_cast<double>(step_)) * step_;
    };
    return {hundredths(p.x), hundredths(p.y)};
}

void SvgPath::begin(char command) {
    if (command == command_) return;
    const bool impliedLine = command_ == 'm' && command == 'l';
    command_ = command;
    if (impliedLine) return;
    text_ += command;
    separate_ = separatesPoint_ = false;
}

void SvgPath::add(long long hundredths) {
    const std::string digits = number(hundredths);
    const bool begins = digits.front() == '-' || (digits.front() == '.' && separatesPoint_);
    if (separate_ && !begins) text_ += ' ';
    text_ += digits;
    separate_ = true;
    separatesPoint_ = digits.find('.') != std::string::npos;
}

void SvgPath::addStep(Point to) {
    add(to.x - at_.x);
    add(to.y - at_.y);
}

void SvgPath::finishSubpath() {
    if (dot_) text_ += "h0";
    dot_ = false;
}

void SvgPath::moveTo(glm::dvec2 pixel) {
    finishSubpath();
    const Point to = rounded(pixel);
    command_ = 0;
    begin('m');  // the first one of a path is absolute anyway
    addStep(to);
    start_ = at_ = to;
    dot_ = true;
}

void SvgPath::lineTo(glm::dvec2 pixel) {
    const Point to = rounded(pixel);
    if (to == at_) return;
    dot_ = false;
    begin('l');
    addStep(to);
    at_ = to;
}

void SvgPath::curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 pixel) {
    const Point to = rounded(pixel);
    const Point first = rounded(control1);
    const Point second = rounded(control2);
    if (to == at_ && first == at_ && second == at_) return;
    dot_ = false;
    begin('c');
    addStep(first);
    addStep(second);
    addStep(to);
    at_ = to;
}

void SvgPath::arcTo(double radius, glm::dvec2 pixel) {
    const Point to = rounded(pixel);
    if (to == at_) return;
    dot_ = false;
    begin('a');
    const long long size = rounded({radius, 0.0}).x;
    for (const long long value : {size, size, 0LL, 0LL, 100LL}) add(value);  // radii, rotation, small, clockwise
    addStep(to);
    at_ = to;
}

void SvgPath::close() {
    finishSubpath();
    text_ += 'z';
    command_ = 'z';
    at_ = start_;
}

std::string SvgPath::text() const { return dot_ ? text_ + "h0" : text_; }

}  // namespace inkedge::io
