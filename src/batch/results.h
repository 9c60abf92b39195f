#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace inkedge::batch {

/// The file of results: whole lines, one an item, in any order. Several processes may append to it.
class Results {
public:
    /// Makes the file if it is not there.
    /// @throws Error  (Kind::Output) if it cannot be written
    explicit Results(std::filesystem::path file);
    ~Results();
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;

    /// Calls take for each line, without its end.
    void read(const std::function<void(std::string_view line)>& take) const;

    /// Appends a line with its end, in one piece.
    /// @throws Error  (Kind::Output) if there is no room
    void append(std::string_view line);

    /// Leaves one line of each id: the last one that says it was drawn, or else the last. Leaves out what is no line.
    void compact();

private:
    void lock();
    void unlock();

    std::filesystem::path path_;
    std::mutex mutex_;
    int file_ = -1;
};

}  // namespace inkedge::batch
