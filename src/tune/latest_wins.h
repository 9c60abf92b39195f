#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>

namespace inkedge::tune {

/// What a tab of a browser asks for at the same time.
enum class Work { Picture, Before, Hover };

/// What tabs ask for. Of one kind of work the last of a tab is done, and ends what the tab asked for before; a picture
/// ends all other work of its tab. Tabs do not disturb each other. May be called from several threads.
class LatestWins {
public:
    /// @param number  counts the requests of a tab, for they may overtake each other
    /// @return        asks to stop once there is later work; at once if there has been
    [[nodiscard]] std::stop_token begin(const std::string& tab, Work, std::uint64_t number);

private:
    struct Last {
        std::stop_source stop;
        std::uint64_t number = 0;
    };
    using Tab = std::array<Last, 3>;  // by Work

    std::mutex guard_;
    std::map<std::string, Tab> tabs_;
};

}  // namespace inkedge::tune
