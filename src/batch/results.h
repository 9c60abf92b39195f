#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "batch/portion.h"

namespace inkedge::batch {

/// The file of a portion's results in a batch's folder: results.jsonl, or results.3-of-8.jsonl.
[[nodiscard]] std::filesystem::path resultsFile(const std::filesystem::path& output, const Portion&);
[[nodiscard]] bool isResultsFile(std::string_view name) noexcept;
/// Those that are there, in the order of their names.
[[nodiscard]] std::vector<std::filesystem::path> resultsFiles(const std::filesystem::path& output);

using TakeLine = std::function<void(std::string_view line)>;

/// Calls take for each line of all files of results in a batch's folder, without its end.
void readResults(const std::filesystem::path& output, const TakeLine&);
/// Calls take for one line of each id: the last one that says it was drawn, or else the last. Leaves out what is no
/// line.
void readChosenResults(const std::filesystem::path& output, const TakeLine&);

/// A file of results: whole lines, one an item, in any order. Several processes may append to it.
class Results {
public:
    /// Makes the file if it is not there.
    /// @throws Error  (Kind::Output) if it cannot be written
    explicit Results(std::filesystem::path file);
    ~Results();
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;

    /// Calls take for each line, without its end.
    void read(const TakeLine&) const;

    /// Appends a line with its end, in one piece.
    /// @throws Error  (Kind::Output) if there is no room
    void append(std::string_view line);

    /// Leaves one line of each id, as readChosenResults() does. Those of other files are put into this one, and the
    /// files removed, even while others append to them.
    void compact(const std::vector<std::filesystem::path>& others = {});

private:
    void lock();
    void unlock();
    void write(const std::vector<std::unique_ptr<Results>>& others);

    std::filesystem::path path_;
    std::mutex mutex_;
    int file_ = -1;
};

}  // namespace inkedge::batch
