#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace inkedge::io {

/// Files that appear together: each is first written whole under a temporary name in its own folder, then all are
/// renamed. What was not committed is removed with the object, so that a failure leaves nothing behind.
class StagedFiles {
public:
    StagedFiles() = default;
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;
    ~StagedFiles();

    /// Writes bytes under a temporary name. A link is followed; what is no regular file (a pipe, a device) cannot be
    /// replaced and is written at once.
    /// @throws Error  (Kind::Output) if target is a folder or protected, or its folder takes no file
    void add(const std::filesystem::path& target, std::span<const std::uint8_t> bytes);

    /// Gives every file its name, in the order in which they were added, over a file that is there already.
    /// @throws Error  (Kind::Output) with the system's reason; files after the one named have not appeared
    void commit();

private:
    struct File {
        std::filesystem::path temporary;
        std::filesystem::path destination;  // target with its links followed
        std::filesystem::path target;       // as the caller named it
    };
    std::vector<File> files_;
};

/// @throws Error  (Kind::Output) always: "TARGET: cannot be written: REASON"
[[noreturn]] void failToWrite(const std::filesystem::path& target, std::string_view reason);

}  // namespace inkedge::io
