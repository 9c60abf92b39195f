#pragma once

#include <memory>
#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "modules/failure.h"
#include "modules/open_module.h"

namespace inkedge::implicit {

/// A function of space.
class Field {
public:
    virtual ~Field() = default;

    /// Its values at some positions. They may be not finite. Safe to ask from several threads.
    virtual void evaluate(std::span<const glm::dvec3> at, std::span<double> values) const = 0;

    [[nodiscard]] double value(glm::dvec3 at) const {
        double found = 0.0;
        evaluate({&at, 1}, {&found, 1});
        return found;
    }
};

// The interface between the library and the muParser module.
struct CompiledField {
    std::shared_ptr<const Field> field;
    std::string failure;
};
struct ExpressionFunctions {
    CompiledField (*compile)(const std::string& expression);
};
inline constexpr modules::ModuleOf<ExpressionFunctions> expressionModule{{.purpose = "expressions of implicit surfaces",
                                                                          .file = "inkedge_muparser.so",
                                                                          .symbol = "inkedge_muparser_1",
                                                                          .library = "muParser",
                                                                          .option = "INKEDGE_MUPARSER",
                                                                          .remedy = "give the surface as a mesh"}};

/// The function of x, y and z that an expression stands for, in muParser's language: + - * / ^, ? :, sqrt, sin, exp,
/// min, max and others, _pi and _e.
/// @throws Error  (Kind::Input) if it is none, or the module is missing
[[nodiscard]] inline std::shared_ptr<const Field> fieldOf(const std::string& expression) {
    constexpr Error::Kind kind = Error::Kind::Input;
    return modules::expectNoFailure(modules::functionsOf<expressionModule>(kind).compile(expression), kind).field;
}

}  // namespace inkedge::implicit
