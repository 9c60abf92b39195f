#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace inkedge::batch {

/// The models in a folder and in those in it, by the extensions of the formats that are read, in the order of their
/// names: the same on every machine. Hidden files and folders are left out, and folders behind links. The names of one
/// folder are held at a time, and of those around it.
class FindModels {
public:
    /// @param leftOut  is not looked into
    FindModels(std::filesystem::path folder, std::filesystem::path leftOut);

    /// The next one.
    /// @throws Error  (Kind::Input) if a folder cannot be read; the next call goes on after it
    [[nodiscard]] std::optional<std::filesystem::path> next();

private:
    void enter(const std::filesystem::path&);

    std::filesystem::path leftOut_;
    std::vector<std::vector<std::filesystem::path>> open_;  // what is still to come, of each folder from its end
};

}  // namespace inkedge::batch
