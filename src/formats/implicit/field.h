#pragma once

#include <memory>
#include <string>

#include "formats/implicit/scalar_field.h"

#include "modules/failure.h"
#include "modules/open_module.h"

namespace inkedge::implicit {

// The interface between the library and the muParser module.
struct CompiledField {
    std::shared_ptr<const ScalarField> field;
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
[[nodiscard]] inline std::shared_ptr<const ScalarField> fieldOf(const std::string& expression) {
    constexpr Error::Kind kind = Error::Kind::Input;
    return modules::expectNoFailure(modules::functionsOf<expressionModule>(kind).compile(expression), kind).field;
}

}  // namespace inkedge::implicit
