#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/settings.h>

// Many models, drawn by worker processes. The command calls it in the shared library; other programs are not offered
// it.
namespace inkedge::batch {

/// How much goes into a tar: one of the two is over 0.
struct ShardSize {
    std::uint64_t items = 0;
    std::uint64_t bytes = 0;
};

/// What one of several tasks draws of a batch: those of its items that hash to an index.
struct Portion {
    std::uint64_t index = 0;
    std::uint64_t count = 1;
};

struct Batch {
    std::filesystem::path input;   ///< a folder of models; a file of items, or "-" for stdin: JSON Lines or paths
    std::filesystem::path output;  ///< folder; made if it is not there
    Settings settings;             ///< of all items, which may have others of their own
    std::string views;             ///< as viewsOf() takes them; empty: one
    std::vector<std::string> formats{"png"};   ///< extensions of pictures and lines
    std::optional<ShardSize> shards;           ///< none: folders
    Portion portion = {};                      ///< the items that are drawn
    int jobs = 0;                              ///< worker processes; 0: as many as there are cores
    double timeout = 300.0;                    ///< seconds that an item may take
    std::uint64_t maxMemory = 0;               ///< bytes that a worker may take; 0: a share of the machine's
    std::optional<std::uint64_t> maxFailures;  ///< the batch ends once more items than this have failed
    bool score = false;                        ///< says how far lines from image space and from object space agree
    bool retry = false;                        ///< draws anew what failed before, whatever the reason
    std::filesystem::path program;             ///< that calls work() when its argument is workerVerb
};
inline constexpr std::string_view workerVerb = "batch-worker";

/// What became of an item.
enum class State {
    Drawn,
    Refused,  ///< its model or its settings are at fault: it cannot be drawn
    Failed,   ///< something else is: no memory, no room for the files
    Crashed,  ///< it alone ended a worker by a crash
    Killed,   ///< or a worker was ended by another
    Timeout,  ///< it took longer than it may
    Memory,   ///< it took more memory than it may
};
inline constexpr std::array<std::string_view, 7> stateNames{"drawn",  "refused", "failed", "crashed",
                                                            "killed", "timeout", "memory"};

struct INKEDGE_API Counts {
    std::array<std::uint64_t, stateNames.size()> now{};     ///< by State: items of this run
    std::array<std::uint64_t, stateNames.size()> before{};  ///< and of runs before it, which are not done again
    std::uint64_t badLines = 0;                             ///< of the file of items: they are no items

    [[nodiscard]] std::uint64_t done() const noexcept;         ///< items, and lines that are none
    [[nodiscard]] std::uint64_t failures() const noexcept;     ///< among them
    [[nodiscard]] std::uint64_t newFailures() const noexcept;  ///< of this run
};

struct Progress {
    Counts counts;
    std::optional<std::uint64_t> items;  ///< once they are counted
    double seconds = 0.0;
    double rate = 0.0;           ///< items a second, of late
    std::optional<double> left;  ///< seconds
};

struct Watch {
    std::function<void(const Progress&)> progress;           ///< called several times a second
    std::function<void(const std::string& message)> failed;  ///< an item, or a line of the file of items
};

/// Draws all items of a portion. OUTPUT/results.jsonl gets a line for each, or a file of the portion's own; what they
/// say was drawn before, of the same model by the same settings and version, and is still there, is not drawn again.
/// Files are whole or not there, whatever ends the process.
/// @throws Error  (Kind::Usage, Kind::Input, Kind::Output) if the batch as a whole cannot be done; (Kind::Context) if
///                there is no OpenGL for it; (Kind::Runtime) if no worker can be started
INKEDGE_API Progress runBatch(const Batch&, const Watch&);

/// What a worker process does: it draws items until nobody sends any more.
[[noreturn]] INKEDGE_API void work();

}  // namespace inkedge::batch
