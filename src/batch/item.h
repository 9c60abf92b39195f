#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/metadata.h"

namespace inkedge::batch {

/// A model that is to be drawn.
struct Item {
    std::uint64_t number = 0;  ///< of the batch's items, from 0
    std::string id = {};       ///< names its folder in the output: names with / between them
    std::filesystem::path model = {};
    std::string views = {};  ///< as viewsOf() takes them; empty: the batch's
    io::Json settings = {};  ///< an object: its own beside the batch's; or null
};

/// An item from one line: {"model": path, "id": ..., "views": ..., "settings": {...}}, all but the model optional, or a
/// path. An item without an id has its model's path as one.
/// @throws Error  (Kind::Input) if it is neither; the message says what was expected
[[nodiscard]] Item itemFrom(std::string_view line);

/// An item of a model that was found.
/// @param relative  its path from the folder that was looked through
/// @throws Error    (Kind::Input) if the path is none that can be an id
[[nodiscard]] Item itemOf(const std::filesystem::path& model, const std::filesystem::path& relative);

/// A line that itemFrom() takes; it does not have the number.
[[nodiscard]] std::string lineOf(const Item&);

}  // namespace inkedge::batch
