#include "batch/old_shards.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "batch/tar.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

std::optional<ShardName> shardName(const fs::path& file) {
    if (file.extension() != ".tar") return {};
    const std::string stem = file.stem().string();
    const std::size_t dot = stem.find('.');
    ShardName name{dot == std::string::npos ? "" : stem.substr(0, dot)};
    const std::string number = dot == std::string::npos ? stem : stem.substr(dot + 1);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), name.number);
    const bool isPortion =
        name.portion.empty() || (name.portion.find("-of-") != std::string::npos &&
                                 name.portion.find_first_not_of("-of0123456789") == std::string::npos);
    if (error != std::errc{} || end != number.data() + number.size() || !isPortion) return {};
    return name;
}

}  // namespace

OpenFile::OpenFile(const fs::path& path) : descriptor_{::open(path.c_str(), O_RDONLY | O_CLOEXEC)} {}

OpenFile::~OpenFile() {
    if (isOpen()) ::close(descriptor_);
}

std::uint64_t OpenFile::size() const noexcept {
    struct stat about {};
    return ::fstat(descriptor_, &about) == 0 ? static_cast<std::uint64_t>(about.st_size) : 0;
}

OldShard::OldShard(const fs::path& path, std::uint64_t its) : number{its}, file{path} {
    if (!file.isOpen()) return;
    for (const TarMember& member : tarMembers(file.descriptor())) {
        const std::string id = member.name.substr(0, member.name.rfind('/'));
        const auto [item, isNew] = items.try_emplace(id, Range{member.begin, member.end});
        item->second.end = member.end;
        end = member.end;
    }
}

fs::path shardFile(const fs::path& output, const Portion& portion, std::uint64_t number) {
    const std::string name = nameOf(portion);
    return output / fmt::format("{}{}{:06}.tar", name, name.empty() ? "" : ".", number);
}

std::vector<ShardName> shardsIn(const fs::path& output) {
    std::vector<ShardName> shards;
    std::error_code failure;
    for (fs::directory_iterator entry{output, failure}; !failure && entry != fs::directory_iterator{};
         entry.increment(failure))
        if (auto shard = shardName(entry->path())) shards.push_back(std::move(*shard));
    return shards;
}

OldShards::OldShards(fs::path output, Portion portion) : output_{std::move(output)}, portion_{portion} {
    for (const ShardName& shard : shardsIn(output_))
        if (shard.portion == nameOf(portion_)) numbers_.push_back(shard.number);
    std::ranges::sort(numbers_);
}

std::shared_ptr<const OldShard> OldShards::shard(std::size_t index) {
    if (index >= numbers_.size()) return {};
    std::shared_ptr<const OldShard>& shard = open_[index];
    if (!shard)
        shard = std::make_shared<const OldShard>(shardFile(output_, portion_, numbers_[index]), numbers_[index]);
    return shard;
}

std::optional<OldShards::Found> OldShards::find(const std::string& id) {
    // What is asked for by several threads comes a little out of order.
    for (const std::size_t index : {current_, current_ + 1, current_ - 1}) {
        const auto among = shard(index);
        if (!among) continue;
        const auto item = among->items.find(id);
        if (item == among->items.end()) continue;
        current_ = std::max(current_, index);
        open_.erase(open_.begin(), open_.lower_bound(current_ == 0 ? 0 : current_ - 1));
        return Found{among, item->second};
    }
    return {};
}

}  // namespace inkedge::batch
