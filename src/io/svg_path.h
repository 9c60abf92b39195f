#pragma once

#include <string>

#include <glm/vec2.hpp>

namespace inkedge::io {

/// The data of an SVG path, short: relative commands, numbers without needless characters. What is rounded off at one
/// place is not lost at the next.
class SvgPath {
public:
    enum class Step { Hundredth = 1, Tenth = 10 };
    explicit SvgPath(Step step = Step::Hundredth) : step_{static_cast<long long>(step)} {}

    void moveTo(glm::dvec2);
    void lineTo(glm::dvec2);
    void curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 to);
    /// A part of a circle of the radius, half of it at most, clockwise on the screen.
    void arcTo(double radius, glm::dvec2);
    void close();

    /// A part that came to no more than one place is a dot there.
    [[nodiscard]] std::string text() const;

private:
    struct Place {
        long long x = 0;  // hundredths
        long long y = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };
    [[nodiscard]] Place rounded(glm::dvec2) const;
    void begin(char command);
    void add(long long hundredths);
    void addStep(Place to);
    void finishPart();

    long long step_;  // hundredths
    std::string text_;
    Place start_;
    Place at_;
    char command_ = 0;             // that further numbers belong to
    bool separatesPoint_ = false;  // a point after the number before would begin a new one
    bool separate_ = false;
    bool dot_ = false;  // nothing but a place so far
};

}  // namespace inkedge::io
