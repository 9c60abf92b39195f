#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace inkedge::cad {

/// A file in a ZIP archive, as the archive's directory lists it.
struct ZipEntry {
    std::string_view name;      ///< in the archive's bytes
    std::uint64_t size = 0;     ///< bytes, unpacked
    std::uint64_t method = 0;   ///< how it is packed: 0 stored, 8 deflated
    std::string_view packed{};  ///< in the archive's bytes
};

/// The directory at an archive's end: PKWARE's APPNOTE 6.3.9, sections 4.3.7 and 4.3.12 to 4.3.16, ZIP64 too. What is
/// packed is not looked at: it may come to another size.
/// @throws Error  (Kind::Input) if there is none, or it is cut short or inconsistent
[[nodiscard]] std::vector<ZipEntry> zipDirectory(std::span<const std::uint8_t> archive);

}  // namespace inkedge::cad
