#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <glm/vec2.hpp>

namespace inkedge::io {

/// Lines, cubic curves and arcs of circles, in any number of subpaths. What SVG, PDF and DXF write of it is asked for
/// by functions of the same names.
class Path {
public:
    void moveTo(glm::dvec2 to) { add(Step::Move, {to}); }
    void lineTo(glm::dvec2 to) { add(Step::Line, {to}); }
    void curveTo(glm::dvec2 control1, glm::dvec2 control2, glm::dvec2 to) {
        add(Step::Curve, {control1, control2, to});
    }
    /// An arc of a circle of the radius, at most half of it, clockwise on the screen.
    void arcTo(double radius, glm::dvec2 to) { add(Step::Arc, {glm::dvec2{radius, 0.0}, to}); }
    void close() { add(Step::Close, {}); }

    [[nodiscard]] bool empty() const noexcept { return steps_.empty(); }

    /// Calls moveTo(), lineTo(), curveTo(), arcTo() and close() of another path in the same order.
    template <class Other>
    void copyTo(Other& other) const {
        std::size_t next = 0;
        for (const Step step : steps_) {
            const glm::dvec2* const at = points_.data() + next;
            switch (step) {
                case Step::Move:
                    other.moveTo(at[0]);
                    next += 1;
                    break;
                case Step::Line:
                    other.lineTo(at[0]);
                    next += 1;
                    break;
                case Step::Curve:
                    other.curveTo(at[0], at[1], at[2]);
                    next += 3;
                    break;
                case Step::Arc:
                    other.arcTo(at[0].x, at[1]);
                    next += 2;
                    break;
                case Step::Close:
                    other.close();
                    break;
            }
        }
    }

private:
    enum class Step : std::uint8_t { Move, Line, Curve, Arc, Close };
    void add(Step step, std::initializer_list<glm::dvec2> points) {
        steps_.push_back(step);
        points_.insert(points_.end(), points);
    }

    std::vector<Step> steps_;
    std::vector<glm::dvec2> points_;  // of all steps; an arc has {radius, 0} first
};

}  // namespace inkedge::io
