#pragma once

#include <string>

#include <glm/vec2.hpp>

namespace inkedge::io {

/// The data of an SVG path, kept short: relative commands, numbers without needless characters. Rounding errors do not
/// add up along the path.
class SvgPath {
public:
    enum class Step { Hundredth = 1, Tenth = 10 };
    explicit SvgPath(Step step = Step::Hundredth) : step_{static_cast<long long>(step)} {}

    void moveTo(glm::dvec2);
    void lineTo(glm::dvec2);
    void curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 to);
    /// An arc of a circle of the radius, at most half of it, clockwise on the screen.
    void arcTo(double radius, glm::dvec2);
    void close();

    /// The data. A subpath of one point is a dot there.
    [[nodiscard]] std::string text() const;

private:
    struct Point {
        long long x = 0;  // hundredths
        long long y = 0;
        friend bool operator==(const Point&, const Point&) = default;
    };
    [[nodiscard]] Point rounded(glm::dvec2) const;
    void begin(char command);
    void add(long long hundredths);
    void addStep(Point to);
    void finishSubpath();

    long long step_;  // hundredths
    std::string text_;
    Point start_;
    Point at_;
    char command_ = 0;             // the command that further numbers belong to
    bool separatesPoint_ = false;  // whether a decimal point after the last number begins a new number
    bool separate_ = false;
    bool dot_ = false;  // whether the subpath has only one point so far
};

}  // namespace inkedge::io
