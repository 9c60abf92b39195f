#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace inkedge::io {

/// The data of SVG paths, kept short: relative commands, numbers without needless characters. Rounding errors do not
/// add up along a path. A path is begun anew before it has more points than readers take: Qt 5 drops, without an error,
/// what follows the 32,767th.
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

    /// The data: of no path if there is none, of several that go on where the one before ends if one would be too long.
    /// Subpaths of fewer than 100 points are whole. A subpath of one point is a dot there.
    [[nodiscard]] std::vector<std::string> texts() const;

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
    void addMove(Point to);
    void addLine(Point to);
    void finishSubpath();
    void beginNext();
    void makeRoom(int points);

    long long step_;  // hundredths
    std::vector<std::string> finished_;
    std::string text_;
    int points_ = 0;  // in text_
    Point start_;
    Point at_;
    char command_ = 0;             // the command that further numbers belong to
    bool separatesPoint_ = false;  // whether a decimal point after the last number begins a new number
    bool separate_ = false;
    bool dot_ = false;    // whether the subpath has only one point so far
    bool isCut_ = false;  // whether it began in an earlier path
};

}  // namespace inkedge::io
