#pragma once

#include <stdexcept>
#include <string>

#include <inkedge/export.h>

namespace inkedge {

/// Every failure that crosses the public interface. what() is one line that says what was expected and what was
/// found, and the remedy where there is one.
class INKEDGE_API Error : public std::runtime_error {
public:
    /// What went wrong. The command's exit code is the number of the kind.
    enum class Kind {
        Runtime = 1,  ///< something failed while rendering: out of memory, a GL error
        Usage = 2,    ///< a setting or an argument is wrong
        Input = 3,    ///< a file cannot be read or holds what we do not support
        Context = 4,  ///< no usable OpenGL context
        Output = 5,   ///< a result cannot be written
        Stopped = 6,  ///< the caller asked to stop: the command never does, signals end it
    };

    /// @param message  one line; control characters in it, say of a file's name, become escapes: "\n", "\x1b"
    Error(Kind kind, const std::string& message);
    ~Error() override;

    [[nodiscard]] Kind kind() const noexcept { return kind_; }

private:
    Kind kind_;
};

}  // namespace inkedge
