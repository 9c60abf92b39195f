#pragma once

#include <functional>
#include <vector>

#include <inkedge/job.h>
#include <inkedge/renderer.h>

#include "io/metadata.h"

namespace inkedge::job {

/// A view, drawn and written.
struct ViewOutcome {
    JobResult result;   ///< without the numbers of job and view
    io::Json metadata;  ///< what they say of the view
};

/// Whether a job's views are drawn with OpenGL.
[[nodiscard]] bool needsContext(const Job&);

/// Draws one view and writes what the job asks for. Lines are found once for all outputs that hold lines, and a picture
/// is drawn once for all others.
/// @param framed    the view, laid on its picture
/// @param before    times of stages before this one
/// @param drawn     called with the picture before anything is written
/// @param metadata  whether JobResult::metadata is wanted
[[nodiscard]] ViewOutcome drawView(const Job&, const View&, const FramedView& framed, const Scene&, Renderer&,
                                   const std::vector<StageTime>& before, const std::function<void(const Maps&)>& drawn,
                                   bool metadata);

/// Writes one file of the metadata of all views.
/// @param views  as ViewOutcome; null: the view could not be drawn
void writeMetadataOfViews(const Job&, const Scene&, std::vector<io::Json> views);

}  // namespace inkedge::job
