#pragma once

#include <filesystem>

namespace inkedge::io {

/// The name of a temporary file in a folder: no file has it yet, and removeTemporaryFiles() removes the one that gets
/// it. Removes the file with the object unless it was renamed; may then be removed already.
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

}  // namespace inkedge::io
