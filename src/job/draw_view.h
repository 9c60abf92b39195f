#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <inkedge/job.h>
#include <inkedge/renderer.h>

#include "io/encode_files.h"
#include "io/metadata.h"

namespace inkedge::job {

/// A view, drawn: what its files are made of, on any thread.
struct DrawnView {
    Settings settings;  ///< the job's, with the view's camera and picture
    std::optional<Maps> maps;
    std::optional<Lines> lines;
};

/// Draws what the job's outputs hold: lines are found once for all that hold lines, a picture is drawn once for all
/// others.
/// @param framed  the view, laid on its picture
[[nodiscard]] DrawnView draw(const Job&, const View&, const FramedView& framed, const Scene&, Renderer&);

/// Makes the files of a view, each at once with its name.
/// @return  their names, in the order of the job's outputs
std::vector<std::filesystem::path> encode(const DrawnView&, const Job&, const View&, const io::TakeFile& take);

/// What metadata say of the view, from the first output.
[[nodiscard]] io::Json metadataOf(const DrawnView&, const Job&, const ViewFiles&);

/// A view, drawn and written.
struct ViewOutcome {
    JobResult result;   ///< without the numbers of job and view
    io::Json metadata;  ///< what they say of the view
};

/// What else is made of a job's scene, beside its outputs.
enum class Besides { Nothing, LinesOfTheMesh };

/// Reads a job's model for pictures from these views.
/// @throws Error  as loadScene()
[[nodiscard]] Scene sceneOf(const Job&, std::span<const View>, Besides = Besides::Nothing);

/// Whether a job's views are drawn with OpenGL.
[[nodiscard]] bool needsContext(const Job&);

/// Whether rays are cast for a job's lines.
[[nodiscard]] bool needsRays(const Job&);

/// Draws one view and writes what the job asks for.
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
