#include "formats/model_input.h"

#include <algorithm>

#include "base/message.h"

namespace inkedge::formats {
namespace {

std::span<const std::uint8_t> expectBytes(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) base::refuse("expected the bytes of a model, found none");
    return bytes;
}

}  // namespace

std::string ModelInput::where() const {
    return isFile() || !name.empty() ? base::printable(name.string()) : "model in memory";
}

base::Bytes startOf(const ModelInput& input, std::size_t size) {
    if (input.isFile()) return base::readStart(input.name, size);
    const std::span<const std::uint8_t> bytes = expectBytes(*input.bytes);
    const auto start = bytes.first(std::min(size, bytes.size()));
    return {start.begin(), start.end()};
}

Content::Content(const ModelInput& input, std::uint64_t& bytesLeft) {
    if (input.isFile()) {
        read_ = base::readBytes(input.name, bytesLeft);
        bytes_ = read_;
        return;
    }
    bytes_ = expectBytes(*input.bytes);
    base::spend(bytes_.size(), bytesLeft);
}

base::Bytes Content::keepOnly(std::span<const std::uint8_t> part) && {
    if (read_.empty()) return {part.begin(), part.end()};
    const auto start = part.data() - read_.data();
    read_.resize(static_cast<std::size_t>(start) + part.size());
    read_.erase(read_.begin(), read_.begin() + start);
    return std::move(read_);
}

}  // namespace inkedge::formats
