#include "batch/earlier.h"

#include "base/content_hash.h"
#include "batch/portion.h"
#include "batch/result.h"

namespace inkedge::batch {
namespace {

std::uint64_t hashOf(const std::string& id, const std::string& key) { return base::hashOf(id + '\n' + key); }

bool areAsTheyWere(const io::Json& files) {
    if (!files.is_object()) return true;
    for (const auto& [file, hash] : files.items())
        if (hash != base::hashOfFile(file).value_or("none")) return false;
    return true;
}

}  // namespace

void Earlier::take(std::string_view line) {
    const std::optional<EarlierResult> earlier = earlierResult(line);
    if (!earlier || !holds(batch_.portion, earlier->id) || !areAsTheyWere(earlier->others)) return;
    const std::uint64_t hash = hashOf(earlier->id, earlier->key);
    switch (earlier->state) {
        case State::Drawn:
            drawn_.insert(hash);
            return;
        case State::Failed:  // the machine's faults may be over
        case State::Killed:
            return;
        case State::Timeout:
            if (earlier->limit.value_or(0.0) < batch_.timeout) return;
            break;
        case State::Memory:
            if (earlier->limit.value_or(0.0) < static_cast<double>(batch_.maxMemory)) return;
            break;
        case State::Refused:
        case State::Crashed:
            break;
    }
    if (!batch_.retry) failed_.emplace(hash, earlier->state);
}

std::optional<State> Earlier::find(const std::string& id, const std::string& key) const {
    const std::uint64_t hash = hashOf(id, key);
    if (drawn_.contains(hash)) return State::Drawn;
    const auto failed = failed_.find(hash);
    if (failed == failed_.end()) return {};
    return failed->second;
}

}  // namespace inkedge::batch
