#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/content_hash.h"
#include "base/read_file.h"
#include "base/staged_files.h"
#include "batch/hash_set.h"
#include "batch/result.h"
#include "batch/results.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

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

// Calls take for the lines that stay of those that read gives.
template <class Read>
void chooseFrom(const Read& read, const Choice& choice, const TakeLine& take) {
    std::size_t number = 0;
    read([&](std::string_view line) {
        if (choice.stays(line, number++)) take(line);
    });
}

template <class Read>
Choice choiceOf(const Read& read) {
    Choice choice;
    read([&](std::string_view line) { choice.look(line); });
    if (choice.allStay()) return choice;
    std::size_t number = 0;
    read([&](std::string_view line) { choice.choose(line, number++); });
    return choice;
}

}  // namespace

void readChosenResults(const fs::path& output, const TakeLine& take) {
    const auto read = [&](const TakeLine& each) { readResults(output, each); };
    chooseFrom(read, choiceOf(read), take);
}

void Results::compact(const std::vector<fs::path>& others) {
    const std::scoped_lock ours{mutex_};
    lock();
    std::vector<std::unique_ptr<Results>> locked;
    for (const fs::path& file : others) {
        locked.push_back(std::make_unique<Results>(file));
        locked.back()->lock();
    }
    write(locked);
    std::error_code ignored;
    for (const auto& other : locked) {
        fs::remove(other->path_, ignored);
        other->unlock();
    }
    unlock();
}

void Results::write(const std::vector<std::unique_ptr<Results>>& others) {
    const auto readAll = [&](const TakeLine& each) {
        read(each);
        for (const auto& other : others) other->read(each);
    };
    const Choice choice = choiceOf(readAll);
    if (choice.allStay() && others.empty()) return;
    base::StagedFiles files;
    files.add(path_, {});
    std::string text;
    const auto flush = [&] {
        files.extend({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        text.clear();
    };
    chooseFrom(readAll, choice, [&](std::string_view line) {
        text.append(line).append("\n");
        constexpr std::size_t enough = 1 << 20;
        if (text.size() > enough) flush();
    });
    flush();
    files.commit();
}

}  // namespace inkedge::batch
