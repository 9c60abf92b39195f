#pragma once

#include <filesystem>
#include <span>

#include <inkedge/error.h>

#include "images/image_formats.h"

namespace inkedge::io {

/// The image formats' functions. The first call opens the module, which takes about half a second; it stays open.
/// @param failure  the kind of the error, if there is one: what the caller was about to do
/// @throws Error   (failure) if the module is not found beside the library, or does not fit it; a later call
///                 tries again
const ImageFormats& imageFormats(Error::Kind failure);

/// The same from the first of these folders that holds the module.
const ImageFormats& openImageFormats(std::span<const std::filesystem::path> folders, Error::Kind failure);

}  // namespace inkedge::io
