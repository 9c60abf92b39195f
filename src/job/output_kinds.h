#pragma once

#include <span>

#include <inkedge/job.h>
#include <inkedge/setting_table.h>

namespace inkedge::job {

/// What kinds of files a job writes, or a picture if it writes none.
/// @param views  of the job, one at least
[[nodiscard]] OutputKinds kindsOf(const Job&, std::span<const View> views);

}  // namespace inkedge::job
