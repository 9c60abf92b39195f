#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include "base/content_hash.h"
#include "base/read_file.h"
#include "base/staged_files.h"
#include "batch/hash_set.h"
#include "batch/result.h"
#include "batch/results.h"

namespace inkedge::batch {
namespace {

// Which lines stay.
class Choice {
public:
    void look(std::string_view line) {
        const std::optional<ResultStart> start = startOf(line);
        if (!start)
            hasOthers_ = true;
        else if (const std::uint64_t id = base::hashOf(start->id); !seen_.insert(id))
            repeated_.insert(id);
    }
    [[nodiscard]] bool allStay() const { return !hasOthers_ && repeated_.empty(); }

    void choose(std::string_view line, std::size_t number) {
        const std::optional<ResultStart> start = startOf(line);
        if (!start || !repeated_.contains(base::hashOf(start->id))) return;
        Chosen& chosen = chosen_[base::hashOf(start->id)];
        if (chosen.drawn && !start->drawn) return;
        chosen = {number, start->drawn};
    }
    [[nodiscard]] bool stays(std::string_view line, std::size_t number) const {
        const std::optional<ResultStart> start = startOf(line);
        if (!start) return false;
        const auto chosen = chosen_.find(base::hashOf(start->id));
        return chosen == chosen_.end() || chosen->second.line == number;
    }

private:
    struct Chosen {
        std::size_t line = 0;
        bool drawn = false;
    };
    HashSet seen_;
    bool hasOthers_ = false;
    std::unordered_set<std::uint64_t> repeated_;  // few: what was done again
    std::unordered_map<std::uint64_t, Chosen> chosen_;
};

}  // namespace

void Results::compact() {
    const std::scoped_lock ours{mutex_};
    lock();
    Choice choice;
    read([&](std::string_view line) { choice.look(line); });
    if (!choice.allStay()) {
        std::size_t number = 0;
        read([&](std::string_view line) { choice.choose(line, number++); });
        base::StagedFiles files;
        files.add(path_, {});
        std::string text;
        const auto flush = [&] {
            files.extend({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
            text.clear();
        };
        number = 0;
        read([&](std::string_view line) {
            if (!choice.stays(line, number++)) return;
            text.append(line).append("\n");
            constexpr std::size_t enough = 1 << 20;
            if (text.size() > enough) flush();
        });
        flush();
        files.commit();
    }
    unlock();
}

}  // namespace inkedge::batch
