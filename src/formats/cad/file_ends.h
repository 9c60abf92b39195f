#pragma once

#include <cstdint>
#include <string_view>

namespace inkedge::cad {

enum class FileKind { Step, Iges, Brep, ThreeMf };

/// "STEP", "IGES", "BREP", "3MF".
[[nodiscard]] std::string_view nameOf(FileKind) noexcept;

/// Looks at the first and the last lines of a file, or the directory of an archive.
/// @param maxUnpacked  bytes that the files of an archive may hold together
/// @throws Error  (Kind::Input) if it is none of its kind, or cut short, or holds more than it may
void expectWhole(std::string_view text, FileKind, std::uint64_t maxUnpacked);

}  // namespace inkedge::cad
