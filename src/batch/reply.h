#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/read_file.h"
#include "batch/batch.h"

namespace inkedge::batch {

/// How a worker answers for an item.
enum class Reply : std::uint8_t {
    Done,       ///< with its state, and its line of the results
    NoContext,  ///< there is no OpenGL for any item: why
};

/// An answer as a message: two bytes, then the text.
[[nodiscard]] inline std::vector<std::uint8_t> packed(Reply reply, State state, std::string_view text) {
    std::vector<std::uint8_t> message{static_cast<std::uint8_t>(reply), static_cast<std::uint8_t>(state)};
    message.insert(message.end(), text.begin(), text.end());
    return message;
}

struct Answer {
    Reply reply;
    State state;
    std::string text;
};
[[nodiscard]] inline Answer unpacked(std::span<const std::uint8_t> message) {
    return {static_cast<Reply>(message[0]), static_cast<State>(message[1]),
            std::string{base::textOf(message.subspan(2))}};
}

}  // namespace inkedge::batch
