#pragma once

#include <array>

#include "gl/embedded_programs.h"
#include "gl/objects.h"

namespace inkedge::gl {

/// The embedded programs, each compiled on first use.
class Programs {
public:
    explicit Programs(const Api& api) : api_{api} {}

    /// @throws Error  (Kind::Runtime) if the driver refuses it: the program's name, the driver's first line and the
    /// file
    ///                that it means
    [[nodiscard]] GLuint id(Program);

private:
    const Api& api_;
    std::array<ProgramName, programCount> compiled_;
};

}  // namespace inkedge::gl
