#include "io/svg_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace inkedge::io {
namespace {

constexpr double largest = 1e9;  // pixels
constexpr int maxPoints = 32'000;
constexpr int wholeSubpath = 100;  // points

// Points as Qt counts them: a curve has its control points, a half circle is two curves.
constexpr int pointsOfCurve = 3;
constexpr int pointsOfArc = 6;

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

void SvgPath::addMove(Point to) {
    command_ = 0;
    begin('m');  // the first one of a path is absolute anyway
    addStep(to);
    at_ = to;
    ++points_;
}

void SvgPath::addLine(Point to) {
    makeRoom(1);
    begin('l');
    addStep(to);
    at_ = to;
}

void SvgPath::finishSubpath() {
    if (dot_) text_ += "h0";
    dot_ = false;
}

void SvgPath::beginNext() {
    finished_.push_back(std::move(text_));
    text_.clear();
    points_ = 0;
    at_ = {};
}

// Makes sure that the path takes so many points more, and counts them.
void SvgPath::makeRoom(int points) {
    if (points_ + points > maxPoints) {
        const Point joint = at_;
        beginNext();
        addMove(joint);
        isCut_ = true;
    }
    points_ += points;
}

void SvgPath::moveTo(glm::dvec2 pixel) {
    finishSubpath();
    if (points_ > maxPoints - wholeSubpath) beginNext();
    start_ = rounded(pixel);
    addMove(start_);
    dot_ = true;
    isCut_ = false;
}

void SvgPath::lineTo(glm::dvec2 pixel) {
    const Point to = rounded(pixel);
    if (to == at_) return;
    dot_ = false;
    addLine(to);
}

void SvgPath::curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 pixel) {
    const Point to = rounded(pixel);
    const Point first = rounded(control1);
    const Point second = rounded(control2);
    if (to == at_ && first == at_ && second == at_) return;
    dot_ = false;
    makeRoom(pointsOfCurve);
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
    makeRoom(pointsOfArc);
    begin('a');
    const long long size = rounded({radius, 0.0}).x;
    for (const long long value : {size, size, 0LL, 0LL, 100LL}) add(value);  // radii, rotation, small, clockwise
    addStep(to);
    at_ = to;
}

void SvgPath::close() {
    finishSubpath();
    if (isCut_) {  // it began in an earlier path
        if (at_ != start_) addLine(start_);
        return;
    }
    text_ += 'z';
    command_ = 'z';
    at_ = start_;
    ++points_;
}

std::vector<std::string> SvgPath::texts() const {
    std::vector<std::string> all = finished_;
    if (!text_.empty()) all.push_back(dot_ ? text_ + "h0" : text_);
    return all;
}

}  // namespace inkedge::io
