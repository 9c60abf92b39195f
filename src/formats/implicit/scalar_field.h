#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace inkedge::implicit {

/// A function of space. Safe to ask from several threads.
class ScalarField {
public:
    virtual ~ScalarField() = default;

    /// Its values at some positions, as many as these. They may be not finite. A call alone costs some microseconds.
    virtual void evaluate(std::span<const glm::dvec3> at, std::span<double> values) const = 0;
};

}  // namespace inkedge::implicit
