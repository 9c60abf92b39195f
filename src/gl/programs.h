#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "gl/embedded_programs.h"
#include "gl/objects.h"

namespace inkedge::gl {

/// The embedded programs, each compiled on first use.
class Programs {
public:
    explicit Programs(const Api& api) : api_{api} {}

    /// @throws Error  (Kind::Runtime) if the driver refuses the program; the message has the program's name, the
    ///                driver's first line and the file that the line is about
    [[nodiscard]] GLuint id(Program);

    /// The program of a surface function: one of shaders/functions, by its name.
    [[nodiscard]] GLuint function(std::string_view name);

    /// The program of a surface function that a user's file defines, compiled once for each text.
    /// @throws Error  (Kind::Input) if the file cannot be read or the driver refuses its text; the message has the
    ///                file, the line and the driver's words
    [[nodiscard]] GLuint customFunction(const std::filesystem::path& file);

private:
    const Api& api_;
    std::array<ProgramName, programCount> compiled_;
    std::map<std::string, ProgramName, std::less<>> functions_;  // by name
    std::map<std::string, ProgramName> customFunctions_;         // by text
};

}  // namespace inkedge::gl
