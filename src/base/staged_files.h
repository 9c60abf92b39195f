#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace inkedge::base {

/// How files are kept until they are whole.
enum class Staging {
    Unnamed,  ///< without a name if the file system has such files: nothing is left, however the process ends
    Named,    ///< under temporary names, which removeTemporaryFiles() removes
};

/// Files that appear together: each is first written whole in its own folder, then all get their names. Files that were
/// not committed are removed with the object, so that a failure leaves nothing behind.
class StagedFiles {
public:
    explicit StagedFiles(Staging = Staging::Unnamed);
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;
    ~StagedFiles();

    /// Writes bytes to a file that does not have its name yet. A target that is no regular file (a pipe, a device)
    /// cannot be replaced, and is written at once.
    /// @throws Error  (Kind::Output) as destinationOf(), or if the target's folder takes no file
    void add(const std::filesystem::path& target, std::span<const std::uint8_t> bytes);

    /// Appends bytes to the file that was added last.
    /// @throws Error  (Kind::Output) if it takes no more
    void extend(std::span<const std::uint8_t> bytes);

    /// Gives every file its name, in the order in which they were added. A file that has the name already is replaced.
    /// @throws Error  (Kind::Output) with the system's reason; files after the one named have not appeared
    void commit();

private:
    struct File;
    Staging staging_;
    std::vector<File> files_;
};

/// The file that a target stands for: a link is followed, so that it stays and what it leads to is replaced.
/// @throws Error  (Kind::Output) if target is a folder, protected, or a link to nothing
[[nodiscard]] std::filesystem::path destinationOf(const std::filesystem::path& target);

/// @throws Error  (Kind::Output) always: "TARGET: cannot be written: REASON"
[[noreturn]] void failToWrite(const std::filesystem::path& target, std::string_view reason);

}  // namespace inkedge::base
