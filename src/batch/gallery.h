#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include <inkedge/export.h>

namespace inkedge::batch {

/// Writes OUTPUT/gallery.html: one page, which needs nothing but the pictures beside it, of what the results say.
/// @param output   of a batch that wrote folders
/// @return         how many items it shows
/// @throws Error   (Kind::Input) if there are no results, or they are of shards; (Kind::Output) if the page cannot be
///                 written
INKEDGE_API std::uint64_t writeGallery(const std::filesystem::path& output);

/// The page; "{results}" stands where a list of the results goes.
[[nodiscard]] std::string_view galleryPage() noexcept;

}  // namespace inkedge::batch
