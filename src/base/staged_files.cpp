#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <inkedge/error.h>
#include <inkedge/write_file.h>

#include "base/staged_files.h"
#include "base/temporary_name.h"

namespace fs = std::filesystem;

namespace inkedge {
namespace base {
namespace {

/// Owns one file descriptor.
class Descriptor {
public:
    explicit Descriptor(int descriptor) noexcept : descriptor_{descriptor} {}
    Descriptor(Descriptor&& from) noexcept : descriptor_{std::exchange(from.descriptor_, -1)} {}
    Descriptor& operator=(Descriptor&& from) noexcept {
        std::swap(descriptor_, from.descriptor_);
        return *this;
    }
    ~Descriptor() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    [[nodiscard]] bool open() const noexcept { return descriptor_ >= 0; }
    [[nodiscard]] int get() const noexcept { return descriptor_; }
    /// Some file systems report a full disk only here.
    [[nodiscard]] bool close() noexcept { return ::close(std::exchange(descriptor_, -1)) == 0; }

private:
    int descriptor_;  // -1: none
};

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path{"."}; }

std::string explain(int error, const fs::path& target) {
    const std::string reason = std::generic_category().message(error);
    const std::string folder = folderOf(target).string();
    switch (error) {
        case ENOENT:
            return fmt::format("expected a folder {}, found none; create it first", folder);
        case ENOTDIR:
            return fmt::format("expected {} to be a folder, found a file in its way; choose another place", folder);
        case EISDIR:
            return "expected a file, found a folder; add a file's name";
        case EACCES:
        case EPERM:
        case EROFS:
            return fmt::format("expected a place that may be written to, found: {}; choose another or change its mode",
                               reason);
        case ENOSPC:
        case EDQUOT:
            return fmt::format("expected room for the file, found: {}; free some or choose another place", reason);
        case EFBIG:
            return fmt::format("expected room for the file, found: {}; raise the limit (ulimit -f) or ask for less",
                               reason);
        default:
            return fmt::format("expected a place that takes the file, found: {}; choose another", reason);
    }
}

[[noreturn]] void failToWrite(const fs::path& target, int error) {
    base::failToWrite(target, std::string_view{explain(error, target)});
}

std::string linkOf(const Descriptor& file) { return fmt::format("/proc/self/fd/{}", file.get()); }

/// A file without a name, which can be given a name if there is /proc; none if the file system has no such files.
Descriptor createUnnamed(const fs::path& folder) {
    Descriptor file{::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666)};
    if (file.open() && ::access(linkOf(file).c_str(), F_OK) != 0) return Descriptor{-1};
    return file;
}

/// @return 0, or the system's error number
int giveName(const Descriptor& unnamed, const char* name) {
    const int result = ::linkat(AT_FDCWD, linkOf(unnamed).c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
    return result == 0 ? 0 : errno;
}

/// @return 0, or the system's error number
int writeAll(const Descriptor& file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    Descriptor duplicate{::dup(file.get())};  // closing any descriptor of a file reports whether its bytes were written
    return duplicate.open() && duplicate.close() ? 0 : errno;
}

void overwrite(const fs::path& target, std::span<const std::uint8_t> bytes) {
    const Descriptor file{::open(target.c_str(), O_WRONLY | O_CLOEXEC)};
    if (!file.open()) failToWrite(target, errno);
    if (const int error = writeAll(file, bytes)) failToWrite(target, error);
}

}  // namespace

fs::path destinationOf(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) failToWrite(target, EISDIR);
    if (status.type() == fs::file_type::not_found) {
        if (!fs::is_symlink(fs::symlink_status(target, error))) return target;
        failToWrite(target,
                    fmt::format("expected a file behind the link, found none at {}; make one or remove the link",
                                fs::read_symlink(target, error).string()));
    }
    if (status.type() == fs::file_type::none) failToWrite(target, error.value());
    if (!fs::is_regular_file(status)) return target;
    if (::access(target.c_str(), W_OK) != 0) failToWrite(target, errno);
    fs::path destination = fs::canonical(target, error);
    if (error) failToWrite(target, error.value());
    return destination;
}

void failToWrite(const fs::path& target, std::string_view reason) {
    throw Error{Error::Kind::Output, fmt::format("{}: cannot be written: {}", target.string(), reason)};
}

struct StagedFiles::File {
    fs::path target;       // as the caller named it
    fs::path destination;  // target with its links followed
    Descriptor data;
    std::optional<TemporaryName> temporary;  // none while the file has no name

    /// @return 0, or the system's error number
    int create(Staging staging) {
        if (staging == Staging::Unnamed) data = createUnnamed(folderOf(destination));
        if (data.open()) return 0;
        temporary.emplace(folderOf(destination));
        data = Descriptor{::open(temporary->path(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
        return data.open() ? 0 : errno;
    }

    /// @return 0, or the system's error number
    int appear() {
        if (!temporary) {
            const int error = giveName(data, destination.c_str());
            if (error != EEXIST) return error;
            temporary.emplace(folderOf(destination));  // only a file with a name can replace another
            if (const int failure = giveName(data, temporary->path())) return failure;
        }
        return std::rename(temporary->path(), destination.c_str()) == 0 ? 0 : errno;
    }
};

StagedFiles::StagedFiles(Staging staging) : staging_{staging} {}
StagedFiles::~StagedFiles() = default;

void StagedFiles::add(const fs::path& target, std::span<const std::uint8_t> bytes) {
    const fs::path destination = destinationOf(target);
    std::error_code ignored;
    const fs::file_status status = fs::status(destination, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) return overwrite(target, bytes);
    File file{target, destination, Descriptor{-1}, {}};
    if (const int failure = file.create(staging_)) failToWrite(target, failure);
    if (const int failure = writeAll(file.data, bytes)) failToWrite(target, failure);
    files_.push_back(std::move(file));
}

void StagedFiles::extend(std::span<const std::uint8_t> bytes) {
    const File& file = files_.back();
    if (const int failure = writeAll(file.data, bytes)) failToWrite(file.target, failure);
}

void StagedFiles::commit() {
    while (!files_.empty()) {
        File& file = files_.front();
        if (const int failure = file.appear()) failToWrite(file.target, failure);
        files_.erase(files_.begin());
    }
}

}  // namespace base

void writeFile(const fs::path& target, std::span<const std::uint8_t> bytes) {
    base::StagedFiles files;
    files.add(target, bytes);
    files.commit();
}

}  // namespace inkedge
