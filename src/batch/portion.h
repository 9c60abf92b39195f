#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "batch/batch.h"

namespace inkedge::batch {

/// Whether an item is one of a portion's: by a hash of its id, so that it stays in one portion whatever other items
/// there are.
[[nodiscard]] bool holds(const Portion&, std::string_view id) noexcept;

/// What names of files of this portion say of it, as "3-of-8"; empty: there is one portion alone.
[[nodiscard]] std::string nameOf(const Portion&);

/// The value of an environment variable; null: there is none.
using Environment = std::function<const char*(const char* name)>;

/// The portion that a task is to draw.
/// @param text  "I/N", I from 0; "auto/N": I by the scheduler that has started this process; empty: likewise, all
///              items where it was no scheduler that numbers its tasks
/// @throws Error  (Kind::Usage) if the text is none of these, or the scheduler does not say enough
INKEDGE_API Portion portionOf(std::string_view text, const Environment&);

}  // namespace inkedge::batch
