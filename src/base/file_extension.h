#pragma once

#include <filesystem>
#include <string>

namespace inkedge::base {

/// A file name's extension with its dot, ASCII letters in lower case: ".png"; empty if there is none.
[[nodiscard]] inline std::string lowerCaseExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    return extension;
}

}  // namespace inkedge::base
