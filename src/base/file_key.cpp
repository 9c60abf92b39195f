#include "base/file_key.h"

#include <sys/stat.h>

#include <fmt/format.h>

namespace inkedge::base {

std::string fileKey(const std::filesystem::path& path) {
    struct stat about {};
    if (::stat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode))
        return fmt::format("{}:{}", about.st_dev, about.st_ino);
    std::error_code failure;
    const std::filesystem::path absolute = std::filesystem::absolute(path, failure);
    if (failure) return path.lexically_normal().string();
    const std::filesystem::path whole = std::filesystem::weakly_canonical(absolute, failure);
    return failure ? path.lexically_normal().string() : whole.string();
}

}  // namespace inkedge::base
