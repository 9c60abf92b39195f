#include "formats/model_input.h"

#include <algorithm>

#include "base/message.h"

namespace inkedge::load {
namespace {

std::span<const std::uint8_t> expectBytes(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) refuse("expected the bytes of a model, found none");
    return bytes;
}

}  // namespace

std::string ModelInput::where() const {
    return isFile() || !name.empty() ? printable(name.string()) : "model in memory";
}

Bytes startOf(const ModelInput& input, std::size_t size) {
    if (input.isFile()) return readStart(input.name, size);
    const std::span<const std::uint8_t> bytes = expectBytes(*input.bytes);
    const auto start = bytes.first(std::min(size, bytes.size()));
    return {start.begin(), start.end()};
}

Content::Content(const ModelInput& input, std::uint64_t& bytesLeft) {
    if (input.isFile()) {
        read_ = readBytes(input.name, bytesLeft);
        bytes_ = read_;
        return;
    }
    bytes_ = expectBytes(*input.bytes);
    spend(bytes_.size(), bytesLeft);
}

Bytes Content::keepOnly(std::span<const std::uint8_t> part) && {
    if (read_.empty()) return {part.begin(), part.end()};
    const auto start = part.data() - read_.data();
    read_.resize(static_cast<std::size_t>(start) + part.size());
    read_.erase(read_.begin(), read_.begin() + start);
    return std::move(read_);
}

}  // namespace inkedge::load
