#pragma once

#include <string_view>

namespace inkedge::cad {

enum class FileKind { Step, Iges, Brep };

/// "STEP", "IGES", "BREP".
[[nodiscard]] std::string_view nameOf(FileKind) noexcept;

/// Looks at the first and the last lines of a file.
/// @throws Error  (Kind::Input) if it is none of its kind, or cut short
void expectWhole(std::string_view text, FileKind);

}  // namespace inkedge::cad
