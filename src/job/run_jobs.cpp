#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/job.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>

#include "base/later.h"
#include "base/parallel.h"
#include "base/stage_clock.h"
#include "base/stop.h"
#include "job/draw_view.h"
#include "job/file_names.h"
#include "job/files_apart.h"
#include "job/own_renderer.h"
#include "render/needs_context.h"

namespace inkedge {
namespace job {
namespace {

constexpr int maximumWorkers = 1024;

// A job under way: its scene is loaded by the worker that gets to it first, and given up after its last view.
struct JobState {
    const Job* job = nullptr;
    std::vector<View> views;
    std::vector<FramedView> framed{};  // one a view if they are framed together; else empty
    std::mutex loading{};
    std::optional<Scene> scene{};
    std::vector<StageTime> times{};    // of loading
    bool failed = false;               // to load
    std::vector<io::Json> metadata{};  // of each view; null: not drawn
    std::atomic<std::size_t> left{0};
};

void loadScene(JobState& state) {
    const base::Stopwatch watch;
    state.scene = sceneOf(*state.job, state.views);
    const double loading = watch.milliseconds();
    const double preparing = state.scene->preparationMilliseconds();
    state.times = {{"load", loading - preparing}, {"prepare", preparing}};
}

class Queue {
public:
    Queue(std::span<const Job> jobs, const JobOptions& options)
        : options_{options}, files_{checkedFiles(jobs)}, states_(jobs.size()) {
        for (std::size_t j = 0; j < jobs.size(); ++j) {
            states_[j].job = &jobs[j];
            states_[j].views = viewsOf(jobs[j]);
            states_[j].left = states_[j].views.size();
            states_[j].metadata.resize(states_[j].views.size());
            for (std::size_t v = 0; v < states_[j].views.size(); ++v) tasks_.push_back({j, v});
        }
    }

    void run() {
        {
            std::vector<std::jthread> others;
            for (std::size_t i = 1; i < workers(); ++i) {
                try {
                    others.emplace_back([this] { work(); });
                } catch (const std::system_error&) {  // the process may have no more threads
                    break;
                }
            }
            work();
        }
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    struct Task {
        std::size_t job;
        std::size_t view;
    };

    [[nodiscard]] std::size_t workers() const {
        constexpr std::size_t viewsWorthAContext = 4;
        const std::size_t maximum =
            options_.workers > 0 ? static_cast<std::size_t>(options_.workers) : base::usableCores();
        return std::clamp<std::size_t>(tasks_.size() / viewsWorthAContext, 1, maximum);
    }

    void work() noexcept {
        OwnRenderer renderer;
        std::optional<base::Later<bool>> rays;  // opened while a scene is loaded
        try {
            const base::StopScope scope{[&] { return options_.stop.stop_requested(); }};
            for (std::size_t i = next_++; i < tasks_.size(); i = next_++) {
                base::stopIfAsked();
                const Task task = tasks_[i];
                JobState& state = states_[task.job];
                if (needsContext(*state.job)) (void)renderer.of(state.job->settings.backend, ContextTime::Meanwhile);
                if (!rays && needsRays(*state.job)) {
                    const auto open = [] { return render::openRays(), true; };
                    rays.emplace(open, base::elementsWorthAThread);
                }
                if (isLoaded(state, task.job)) drawView(state, task, renderer);
                if (--state.left == 0) finish(state, task.job);
                const std::scoped_lock lock{calling_};
                ++ended_;
                if (options_.progress) options_.progress(ended_, tasks_.size());
            }
        } catch (...) {
            next_ = tasks_.size();
            const std::scoped_lock lock{calling_};
            if (!failure_) failure_ = std::current_exception();
        }
    }

    bool isLoaded(JobState& state, std::size_t number) {
        const std::scoped_lock lock{state.loading};
        if (state.scene || state.failed) return !state.failed;
        try {
            if (state.job->scene)
                state.scene = state.job->scene;
            else
                loadScene(state);
            for (const auto& file : state.scene->source().files)
                files_.expectNoOutput(file, fmt::format("a file of {},", state.job->model.string()));
            if (framedTogether(state.views)) state.framed = frameViews(*state.scene, state.views, state.job->settings);
            const std::scoped_lock callLock{calling_};
            if (options_.loaded) options_.loaded(number, *state.scene);
        } catch (...) {
            state.failed = true;
            fail({number, std::nullopt, std::current_exception()});
        }
        return !state.failed;
    }

    void drawView(JobState& state, const Task& task, OwnRenderer& renderer) {
        const auto reportDrawn = [&](const Maps& maps) {
            const std::scoped_lock lock{calling_};
            if (options_.drawn) options_.drawn(task.job, task.view, maps);
        };
        JobResult result;
        try {
            const View& view = state.views[task.view];
            const FramedView framed = state.framed.empty()
                                          ? frameViews(*state.scene, {&view, 1}, state.job->settings).front()
                                          : state.framed[task.view];
            ViewOutcome drawn =
                job::drawView(*state.job, view, framed, *state.scene, renderer.of(state.job->settings.backend),
                              task.view == 0 ? state.times : std::vector<StageTime>{}, reportDrawn, options_.metadata);
            result = std::move(drawn.result);
            if (hasOneMetadataFile(*state.job)) state.metadata[task.view] = std::move(drawn.metadata);
        } catch (...) {
            return fail({task.job, task.view, std::current_exception()});
        }
        result.job = task.job;
        result.view = task.view;
        const std::scoped_lock lock{calling_};
        if (options_.finished) options_.finished(result);
    }

    // After a job's last view.
    void finish(JobState& state, std::size_t number) {
        try {
            if (state.scene && hasOneMetadataFile(*state.job))
                writeMetadataOfViews(*state.job, *state.scene, std::move(state.metadata));
        } catch (...) {
            fail({number, std::nullopt, std::current_exception()});
        }
        state.scene.reset();
    }

    void fail(const JobFailure& failure) {
        base::stopIfAsked();
        if (!options_.failed) std::rethrow_exception(failure.error);
        const std::scoped_lock lock{calling_};
        options_.failed(failure);
    }

    const JobOptions& options_;
    const FilesApart files_;
    std::vector<JobState> states_;
    std::vector<Task> tasks_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex calling_;  // held while one of the options' functions is called
    std::size_t ended_ = 0;
    std::exception_ptr failure_;
};

}  // namespace
}  // namespace job

void runJobs(std::span<const Job> jobs, const JobOptions& options) {
    if (options.workers < 0 || options.workers > job::maximumWorkers) {
        throw Error{Error::Kind::Usage,
                    fmt::format("workers: expected 0 to {}, found {}", job::maximumWorkers, options.workers)};
    }
    job::Queue{jobs, options}.run();
}

}  // namespace inkedge
