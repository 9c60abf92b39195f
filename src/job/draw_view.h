#pragma once

#include <functional>
#include <vector>

#include <inkedge/job.h>
#include <inkedge/renderer.h>

namespace inkedge::job {

/// Draws one view and writes what the job asks for. Lines are found once for all outputs that hold lines, and a picture
/// is drawn once for all others.
/// @param framed  the view, laid on its picture
/// @param before  times of stages before this one
/// @param drawn   called with the picture before anything is written
/// @return        without the numbers of job and view
[[nodiscard]] JobResult drawView(const Job&, const View&, const FramedView& framed, const Scene&, Renderer&,
                                 const std::vector<StageTime>& before, const std::function<void(const Maps&)>& drawn);

}  // namespace inkedge::job
