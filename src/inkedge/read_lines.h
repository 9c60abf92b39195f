#pragma once

#include <filesystem>
#include <string_view>

#include <inkedge/export.h>
#include <inkedge/lines.h>

namespace inkedge {

/// Lines from the text of linesJson(): all that it wrote, as exactly as it wrote it; backend and times are empty.
/// Settings are not read, nor is what follows from other values (projection, eye), nor are keys of which nothing is
/// known.
/// @param text    UTF-8; lists and objects lie at most 16 deep, and a line has at most 8388608 values (seven a point)
/// @throws Error  (Kind::Input) if it is no JSON, is over these limits, has another format or version, or a value is
///                missing, of another type or out of range: one line that names the key, what was expected and what was
///                found
[[nodiscard]] INKEDGE_API Lines linesFromJson(std::string_view text);

/// The same from a file, of at most 1 GiB.
/// @throws Error  (Kind::Input) likewise, or if the file cannot be read; the message begins with its name
[[nodiscard]] INKEDGE_API Lines readLines(const std::filesystem::path&);

}  // namespace inkedge
