#include "batch/shards.h"

#include <unistd.h>

#include <algorithm>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/staged_files.h"
#include "batch/tar.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;

void copy(const OpenFile& from, OldShard::Range range, base::StagedFiles& to) {
    std::vector<std::uint8_t> bytes(std::size_t{1} << 20U);
    while (range.begin < range.end) {
        const std::size_t wanted = std::min<std::uint64_t>(bytes.size(), range.end - range.begin);
        const ssize_t count = ::pread(from.descriptor(), bytes.data(), wanted, static_cast<off_t>(range.begin));
        if (count <= 0)
            throw Error{Error::Kind::Runtime,
                        "expected the files of an item, found fewer bytes; start the batch again"};
        to.extend(std::span{bytes}.first(static_cast<std::size_t>(count)));
        range.begin += static_cast<std::uint64_t>(count);
    }
}

}  // namespace

Shards::Shards(fs::path output, ShardSize size, Portion portion)
    : output_{std::move(output)}, size_{size}, portion_{portion}, old_{output_, portion} {}

void Shards::add(std::uint64_t number, Source source) {
    const std::scoped_lock lock{mutex_};
    ready_.emplace(number, std::move(source));
}

bool Shards::takeEarlier(std::uint64_t number, const std::string& id, const fs::path& part) {
    std::error_code ignored;
    if (fs::exists(output_ / part, ignored)) {
        take(number, id, part);
        return true;
    }
    const std::scoped_lock lock{mutex_};
    const auto found = old_.find(id);
    if (found) ready_.emplace(number, Source{id, {}, found->shard, found->range});
    return found.has_value();
}

void Shards::take(std::uint64_t number, const std::string& id, const fs::path& part) {
    std::error_code ignored;
    add(number, {id, part, {}, {0, fs::file_size(output_ / part, ignored)}});
}

void Shards::leaveOut(std::uint64_t number) { add(number, {}); }

void Shards::write() {
    while (true) {
        std::optional<Source> source;
        {
            const std::scoped_lock lock{mutex_};
            const auto first = ready_.begin();
            if (first == ready_.end() || first->first != next_) return;
            source = std::move(first->second);
            ready_.erase(first);
        }
        ++next_;
        if (isFull(*source)) close();
        bytes_ += source->range.end - source->range.begin;
        current_.push_back(std::move(*source));
    }
}

bool Shards::isFull(const Source& next) const {
    if (size_.items > 0) return current_.size() == size_.items;
    return bytes_ > 0 && bytes_ + (next.range.end - next.range.begin) > size_.bytes;
}

// Whether the file of the current shard holds its items already, in their order, and nothing else.
bool Shards::isThere() const {
    std::uint64_t end = 0;
    const OldShard* shard = nullptr;
    for (const Source& source : current_) {
        if (source.id.empty()) continue;
        if (!source.shard || source.shard->number != number_ || source.range.begin != end) return false;
        end = source.range.end;
        shard = source.shard.get();
    }
    return shard != nullptr && end == shard->end;
}

void Shards::close() {
    const fs::path file = shardFile(output_, portion_, number_);
    std::error_code ignored;
    if (bytes_ == 0)
        fs::remove(file, ignored);
    else if (!isThere())
        writeShard(file);
    for (const Source& source : current_)
        if (!source.part.empty()) fs::remove(output_ / source.part, ignored);
    current_.clear();
    bytes_ = 0;
    ++number_;
}

void Shards::writeShard(const fs::path& file) {
    base::StagedFiles staged;
    staged.add(file, {});
    std::optional<OldShard> ofAnother;
    for (const Source& source : current_) {
        if (source.id.empty()) continue;
        if (source.shard) {
            copy(source.shard->file, source.range, staged);
            continue;
        }
        const OpenFile part{output_ / source.part};
        if (part.isOpen()) {
            copy(part, {0, part.size()}, staged);
            continue;
        }
        // Another copy of this batch has put it into the shard meanwhile.
        if (!ofAnother) ofAnother.emplace(file, number_);
        const auto found = ofAnother->items.find(source.id);
        if (found == ofAnother->items.end())
            throw Error{Error::Kind::Runtime,
                        fmt::format("{}: expected the files of {}, found none; start the batch again",
                                    (output_ / source.part).string(), source.id)};
        copy(ofAnother->file, found->second, staged);
    }
    staged.extend(tarEnd());
    staged.commit();
}

void Shards::finish() {
    write();
    if (!current_.empty()) close();
    std::error_code ignored;
    while (fs::remove(shardFile(output_, portion_, number_), ignored)) ++number_;
}

}  // namespace inkedge::batch
