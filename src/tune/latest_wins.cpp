#include "tune/latest_wins.h"

namespace inkedge::tune {
namespace {

constexpr std::size_t maxTabs = 256;  // who asks for more loses no picture, only what ends the earlier ones

}  // namespace

std::stop_token LatestWins::begin(const std::string& tab, Work work, std::uint64_t number) {
    const std::scoped_lock lock{guard_};
    if (tabs_.size() >= maxTabs && !tabs_.contains(tab)) tabs_.clear();
    Tab& all = tabs_[tab];
    Last& last = all[static_cast<std::size_t>(work)];
    std::stop_source source;
    if (number < last.number || number < all.front().number) {
        source.request_stop();
        return source.get_token();
    }
    if (work == Work::Picture) {
        for (Last& each : all) each.stop.request_stop();
    }
    last.stop.request_stop();
    last = {source, number};
    return source.get_token();
}

}  // namespace inkedge::tune
