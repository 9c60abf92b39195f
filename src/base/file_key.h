#pragma once

#include <filesystem>
#include <string>

namespace inkedge::base {

/// What tells files apart: paths that lead to one file have the same key, by links or another spelling, whether or not
/// the file is there yet.
[[nodiscard]] std::string fileKey(const std::filesystem::path&);

}  // namespace inkedge::base
