#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

namespace inkedge::base {

/// Distinguishes the contents of a file without reading it: when it was last written, and its size in bytes.
struct FileStamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// All zero where there is no file.
[[nodiscard]] inline FileStamp stampOf(const std::filesystem::path& file) noexcept {
    std::error_code failure;
    FileStamp stamp{std::filesystem::last_write_time(file, failure), 0};
    if (!failure) stamp.size = std::filesystem::file_size(file, failure);
    return failure ? FileStamp{} : stamp;
}

/// What was made of files. It is made again when a file has another stamp, as build tools do.
template <class Made>
class KeptFiles {
public:
    /// @param make  () -> Made, of this file
    /// @return      valid until the file is asked for with another stamp
    /// @throws      what make throws: what was made before is dropped then
    template <class Make>
    const Made& of(const std::filesystem::path& file, Make&& make) {
        // Before the file is read, so that what is written meanwhile is read next time.
        const FileStamp stamp = stampOf(file);
        const auto known = kept_.find(file);
        if (known != kept_.end() && known->second.stamp == stamp) return known->second.made;
        if (known != kept_.end()) kept_.erase(known);
        return kept_.emplace(file, Kept{stamp, make()}).first->second.made;
    }

private:
    struct Kept {
        FileStamp stamp;
        Made made;
    };
    std::map<std::filesystem::path, Kept> kept_;
};

}  // namespace inkedge::base
