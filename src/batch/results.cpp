#include "batch/results.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/staged_files.h"

namespace inkedge::batch {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
    base::failToWrite(file, fmt::format("expected room for a line, found: {}; free some or choose another --output",
                                        std::generic_category().message(error)));
}

int opened(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) fail(path, errno);
    return file;
}

constexpr std::string_view start = "results.";
constexpr std::string_view end = "jsonl";

}  // namespace

std::filesystem::path resultsFile(const std::filesystem::path& output, const Portion& portion) {
    const std::string name = nameOf(portion);
    return output / fmt::format("{}{}{}{}", start, name, name.empty() ? "" : ".", end);
}

bool isResultsFile(std::string_view name) noexcept { return name.starts_with(start) && name.ends_with(end); }

std::vector<std::filesystem::path> resultsFiles(const std::filesystem::path& output) {
    std::vector<std::filesystem::path> files;
    std::error_code failure;
    for (std::filesystem::directory_iterator entry{output, failure};
         !failure && entry != std::filesystem::directory_iterator{}; entry.increment(failure))
        if (isResultsFile(entry->path().filename().string())) files.push_back(entry->path());
    std::ranges::sort(files);
    return files;
}

void readResults(const std::filesystem::path& output, const TakeLine& take) {
    for (const std::filesystem::path& file : resultsFiles(output)) {
        std::ifstream stream{file, std::ios::binary};
        for (std::string line; std::getline(stream, line);) take(line);
    }
}

Results::Results(std::filesystem::path file) : path_{base::destinationOf(file)}, file_{opened(path_)} {
    struct stat about {};
    // A line that was cut short ends here, so that the next one is whole.
    char last = '\n';
    if (::fstat(file_, &about) == 0 && about.st_size > 0 && ::pread(file_, &last, 1, about.st_size - 1) == 1 &&
        last != '\n')
        append("\n");
}

Results::~Results() { ::close(file_); }

// Another process may have put a compact file in the place of the one that is open.
void Results::lock() {
    while (true) {
        while (::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
        }
        struct stat open {};
        struct stat named {};
        const bool same = ::fstat(file_, &open) == 0 && ::stat(path_.c_str(), &named) == 0 &&
                          open.st_ino == named.st_ino && open.st_dev == named.st_dev;
        if (same) return;
        const int file = opened(path_);
        ::close(std::exchange(file_, file));
    }
}

void Results::unlock() { ::flock(file_, LOCK_UN); }

void Results::append(std::string_view line) {
    const std::scoped_lock ours{mutex_};
    lock();
    const ssize_t written = ::write(file_, line.data(), line.size());
    const int failure = written < 0 ? errno : ENOSPC;
    unlock();
    if (written != static_cast<ssize_t>(line.size())) fail(path_, failure);
}

void Results::read(const TakeLine& take) const {
    std::ifstream stream{path_, std::ios::binary};
    for (std::string line; std::getline(stream, line);) take(line);
}

}  // namespace inkedge::batch
