#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include <inkedge/error.h>
#include <inkedge/write.h>

#include "io/file.h"

namespace fs = std::filesystem;

namespace inkedge {
namespace io {
namespace {

/// Owns one file descriptor.
class Descriptor {
public:
    explicit Descriptor(int descriptor) noexcept : descriptor_{descriptor} {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
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
        default:
            return reason;
    }
}

[[noreturn]] void failToWrite(const fs::path& target, int error) {
    io::failToWrite(target, std::string_view{explain(error, target)});
}

/// Creates a file that was not there before; leaves its name in `name`.
Descriptor createTemporary(const fs::path& folder, fs::path& name) {
    static std::atomic<unsigned> count{0};
    for (;;) {
        name = folder / fmt::format(".inkedge-{}-{}.tmp", ::getpid(), count++);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return Descriptor{descriptor};
    }
}

/// @return 0, or the system's error number
int writeAll(Descriptor& file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return file.close() ? 0 : errno;
}

void writeInPlace(const fs::path& target, std::span<const std::uint8_t> bytes) {
    Descriptor file{::open(target.c_str(), O_WRONLY | O_CLOEXEC)};
    if (!file.open()) failToWrite(target, errno);
    if (const int error = writeAll(file, bytes)) failToWrite(target, error);
}

}  // namespace

void failToWrite(const fs::path& target, std::string_view reason) {
    throw Error{Error::Kind::Output, fmt::format("{}: cannot be written: {}", target.string(), reason)};
}

StagedFiles::~StagedFiles() {
    std::error_code ignored;
    for (const File& file : files_) fs::remove(file.temporary, ignored);
}

void StagedFiles::add(const fs::path& target, std::span<const std::uint8_t> bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) failToWrite(target, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) return writeInPlace(target, bytes);
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) failToWrite(target, errno);

    const fs::path destination = fs::exists(status) ? fs::canonical(target, error) : target;
    if (error && fs::exists(status)) failToWrite(target, error.value());
    files_.reserve(files_.size() + 1);
    File file{{}, destination, target};
    Descriptor descriptor = createTemporary(folderOf(destination), file.temporary);
    if (!descriptor.open()) failToWrite(target, errno);
    files_.push_back(std::move(file));
    if (const int failure = writeAll(descriptor, bytes)) {
        fs::remove(files_.back().temporary, error);
        files_.pop_back();
        failToWrite(target, failure);
    }
}

void StagedFiles::commit() {
    while (!files_.empty()) {
        const File& file = files_.front();
        std::error_code error;
        fs::rename(file.temporary, file.destination, error);
        if (error) failToWrite(file.target, error.value());
        files_.erase(files_.begin());
    }
}

}  // namespace io

void writeFile(const fs::path& target, std::span<const std::uint8_t> bytes) {
    io::StagedFiles files;
    files.add(target, bytes);
    files.commit();
}

}  // namespace inkedge
