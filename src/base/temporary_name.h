#pragma once

#include <filesystem>

#include <inkedge/export.h>

namespace inkedge::base {

/// Removes the temporary files of every write under way in this process; those writes then fail. For the handler of a
/// signal that ends the process: async-signal-safe, to be followed by _exit(). The command calls it in the shared
/// library; other programs are not offered it.
INKEDGE_API void removeTemporaryFiles() noexcept;

/// The name of a temporary file in a folder. No file has the name yet. removeTemporaryFiles() removes the file that
/// gets it, and so does the destructor, unless the file was renamed.
class TemporaryName {
public:
    explicit TemporaryName(const std::filesystem::path& folder);
    TemporaryName(TemporaryName&& from) noexcept;
    TemporaryName& operator=(TemporaryName&& from) noexcept;
    ~TemporaryName();

    [[nodiscard]] const char* path() const noexcept { return path_; }

private:
    struct Slot;
    friend void removeNamed() noexcept;

    static Slot& free();

    const char* path_ = nullptr;
    Slot* slot_ = nullptr;  // null once moved from
};

/// What removeTemporaryFiles() does. Async-signal-safe.
void removeNamed() noexcept;

}  // namespace inkedge::base
