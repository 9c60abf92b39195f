#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <inkedge/backends.h>
#include <inkedge/export.h>
#include <inkedge/maps.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>
#include <inkedge/stage_time.h>
#include <inkedge/views.h>

namespace inkedge {

/// One model, drawn from its views into its files. In names of files "{model}" stands for the model's name without
/// folder and extension, "{view}" for View::name, "{map}" for "outline" or a map's name. What is filled in stays as it
/// is, braces in a model's name too.
struct Job {
    std::filesystem::path model;
    /// The model's file in memory, which must outlive the work; model is then the file's name. None: it is read.
    std::optional<std::span<const std::uint8_t>> bytes = {};
    std::optional<Scene> scene = {};  ///< the model, already loaded; none: it is read from its file, with
                                      ///< loadSettings(settings), and given up after its last view
    Settings settings = {};
    std::vector<View> views = {};           ///< empty: one, of settings.camera, whose name is "0"
    std::vector<std::string> outputs = {};  ///< pictures, as writeMaps() takes them, and lines, as writeLines() does;
                                            ///< none: pictures are drawn for JobOptions::drawn alone
    /// File for metadataJson(), of the first output; without "{view}" in it one of all views. Empty: none.
    std::string metadata = {};
    /// What was read for the job beside the model, its brush and its functions (a list of views, a configuration): no
    /// output may replace it.
    std::vector<std::filesystem::path> inputs = {};
};

/// One view of a job, drawn and written.
struct JobResult {
    std::size_t job = 0;                       ///< counts the jobs that were given
    std::size_t view = 0;                      ///< counts the job's views
    std::vector<std::filesystem::path> files;  ///< what was written, in the order of Job::outputs; without metadata
    std::string metadata;                      ///< metadataJson(); empty unless JobOptions::metadata asks for it
    BackendInfo backend;                       ///< empty: drawn without OpenGL
    std::vector<StageTime> times;              ///< of the job's first view: "load" and "prepare" among them
};

/// What could not be drawn or written.
struct JobFailure {
    std::size_t job = 0;  ///< counts the jobs that were given
    /// Counts the job's views; none: the model could not be read, so none is drawn, or metadata of all views could not
    /// be written.
    std::optional<std::size_t> view;
    std::exception_ptr error;  ///< an Error, unless memory ran out
};

/// The settings that cannot act on any output of a job, as idleSettings() of its settings gives them; of a job without
/// outputs, on a picture.
[[nodiscard]] INKEDGE_API std::vector<std::string> idleSettings(const Job&);

/// How jobs are run. The functions may be left out. They are called on the threads that draw, one call at a time; what
/// loaded and drawn throw is that job's or view's failure, what the others throw ends the work.
struct JobOptions {
    /// Renderers that draw at the same time, 1 to 1024; 0: as many as there are cores. Each costs a context and a copy
    /// of its scene on the graphics side: no more are made than one for every four views.
    int workers = 0;
    bool metadata = false;  ///< fill in JobResult::metadata
    /// A job's scene is there; none of its views is drawn yet.
    std::function<void(std::size_t job, const Scene&)> loaded = {};
    /// A picture is drawn, and neither it nor metadata are written yet. Not called for a job all of whose outputs are
    /// lines.
    std::function<void(std::size_t job, std::size_t view, const Maps&)> drawn = {};
    /// All files of a view are written.
    std::function<void(const JobResult&)> finished = {};
    /// Something failed; the rest is done nevertheless. Without this function the first failure ends the work.
    std::function<void(const JobFailure&)> failed = {};
    /// So many of all jobs' views are done with, finished or failed.
    std::function<void(std::size_t ended, std::size_t views)> progress = {};
    /// Ends the work when it is asked to stop: views being drawn are given up, and nothing is written of them; a model
    /// being read is given up once it is read; views being written are finished.
    std::stop_token stop = {};
};

/// The files that a view of a job is written to: one of each output, its maps' after it, then that of metadata.
/// @throws Error  (Kind::Usage) if an output's extension is none that can be written, or the model's or the view's name
///                would lead out of the output's folder
[[nodiscard]] INKEDGE_API std::vector<std::filesystem::path> filesOf(const Job&, const View&);

/// Finds before the work what would fail after it. Messages name outputs and settings by the command's flags.
/// @throws Error  (Kind::Usage) if validate() refuses a setting, as filesOf(), if one file is asked for twice or is
///                read for one of the jobs, by whatever spelling or link, or an output takes lines and a setting asks
///                for what is no line; (Kind::Output) if a file's folder is not there, or the file is a folder,
///                protected or a link to nothing
INKEDGE_API void checkJobs(std::span<const Job>);

/// Checks the jobs and draws their views, in this order, by several renderers at once: a software driver leaves cores
/// idle between its own threads, and a graphics processor while pictures are encoded. Returns when all is done. A file
/// appears whole or not at all. No more than two scenes a worker are held at once.
/// @throws Error  as checkJobs() does, (Kind::Usage) if the workers are not 0 to 1024, or as loadScene(),
///                frameCamera(), Renderer, writeMaps() and writeLines() do: what failed first, unless options.failed
///                takes it. Views under way at that time are finished. (Kind::Stopped) if options.stop is asked to
///                stop before all is done.
INKEDGE_API void runJobs(std::span<const Job>, const JobOptions& options = {});

}  // namespace inkedge
