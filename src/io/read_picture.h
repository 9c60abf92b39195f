#pragma once

#include <filesystem>

#include "images/image_formats.h"

namespace inkedge::io {

/// The picture of a file of any format that OpenImageIO reads; a PNG needs no module.
/// @throws Error  (Kind::Input) if it is no regular file, empty, or cannot be read as a picture; the message
///                begins with its name
[[nodiscard]] images::ReadPicture readPicture(const std::filesystem::path&);

}  // namespace inkedge::io
