// What a worker process does. One thread reads models, one draws, with one context for all of them, and one encodes and
// writes: neighbouring items are under way at the same time.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <inkedge/error.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>
#include <inkedge/setting_table.h>

#include "base/content_hash.h"
#include "base/read_file.h"
#include "base/stage_clock.h"
#include "batch/batch.h"
#include "batch/channel.h"
#include "batch/item.h"
#include "batch/item_files.h"
#include "batch/plan.h"
#include "batch/reply.h"
#include "batch/result.h"
#include "io/names_json.h"
#include "job/draw_view.h"
#include "job/file_names.h"
#include "job/own_renderer.h"
#include "lines/lengths.h"
#include "process/program_side.h"

namespace inkedge::batch {
namespace {

using io::Json;

// An item under way. Each thread that it comes to has members of its own.
struct Work {
    Item item{};
    Plan plan{};

    std::optional<Scene> scene{};  // of the thread that draws, once it is read
    std::vector<FramedView> framed{};
    std::atomic<bool> givenUp = false;

    Result result{};  // of the thread that writes
    Json facts{};     // of the model, in all camera files
    std::optional<ItemFiles> files{};
    std::exception_ptr failure{};
};
using WorkPointer = std::shared_ptr<Work>;

// What was drawn of an item's next view, or why nothing was, or that no more comes.
struct Drawn {
    WorkPointer work;
    const View* view = nullptr;
    std::optional<job::DrawnView> drawn{};
    std::exception_ptr failure{};
    std::optional<Agreement> score{};
    double seconds = 0.0;  // that it took
};

Json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json factsOf(const Work& work) {
    const Scene& scene = *work.scene;
    Json json{{"id", work.item.id},
              {"model", work.item.model.string()},
              {"bounds", io::boundsJson(scene.bounds())},
              {"up", vectorJson(scene.up())},
              {"triangles", scene.triangleCount()}};
    const std::vector<Map> maps = job::withMapsOf(work.plan.job.outputs, work.plan.job.settings).maps;
    if (std::ranges::find(maps, Map::Ids) != maps.end()) {
        const SceneNames names = namesOf(scene);
        json["instances"] = io::instancesJson(names);
        json["materials"] = io::materialsJson(names);
    }
    return json;
}

Json othersOf(const Scene& scene) {
    Json json;  // null
    for (const auto& file : scene.source().files) json[file.string()] = base::hashOfFile(file).value_or("none");
    return json;
}

void setFailure(Result& result, const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        const bool refused = error.kind() == Error::Kind::Input || error.kind() == Error::Kind::Usage;
        result.state = refused ? State::Refused : State::Failed;
        result.error = error.what();
    } catch (const std::bad_alloc&) {
        result.state = State::Failed;
        result.error = "expected enough memory, found too little";
    } catch (const std::exception& error) {
        result.state = State::Failed;
        result.error = error.what();
    }
}

bool isOfContext(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        return error.kind() == Error::Kind::Context;
    } catch (...) {
        return false;
    }
}

class Worker {
public:
    explicit Worker(const std::string& text) : planner_{text} {}

    [[noreturn]] void run() {
        const std::jthread drawing{[this] { draw(); }};
        const std::jthread writing{[this] { write(); }};
        while (true) {
            const std::vector<std::uint8_t> message = process::receiveMessage();  // at the end it ends the process
            const base::Stopwatch watch;
            const auto work = std::make_shared<Work>();
            work->item = itemFrom(base::textOf(message));
            try {
                load(*work);
            } catch (...) {
                work->failure = std::current_exception();
            }
            work->result.seconds = secondsOf(watch);
            loaded_.put(work);
        }
    }

private:
    static double secondsOf(const base::Stopwatch& watch) { return watch.milliseconds() / 1000.0; }

    void load(Work& work) {
        work.result.id = work.item.id;
        work.result.model = work.item.model.string();
        work.plan = planner_.planOf(work.item);
        work.result.key = keyOf(work.plan, work.item.model);
        validate(work.plan.job.settings);
        const auto besides = work.plan.score ? job::Besides::LinesOfTheMesh : job::Besides::Nothing;
        work.scene = job::sceneOf(work.plan.job, work.plan.views, besides);
        work.framed = frameViews(*work.scene, work.plan.views, work.plan.job.settings);
        work.facts = factsOf(work);
        work.result.triangles = work.scene->triangleCount();
        work.result.warnings = work.scene->warnings();
        work.result.others = othersOf(*work.scene);
    }

    void draw() {
        const Job& common = planner_.common().job;
        if (job::needsContext(common)) (void)renderer_.of(common.settings.backend, ContextTime::Meanwhile);
        while (true) {
            const WorkPointer work = loaded_.take();
            const std::size_t views = work->failure ? 0 : work->plan.views.size();
            for (std::size_t i = 0; i < views && !work->givenUp; ++i) {
                const base::Stopwatch watch;
                Drawn drawn{work, &work->plan.views[i]};
                try {
                    drawn.drawn = drawView(*work, i);
                    if (work->plan.score) drawn.score = scoreOf(*work, *drawn.drawn, work->framed[i]);
                } catch (...) {
                    renderer_.giveUp();
                    drawn = {work, nullptr, {}, std::current_exception()};
                    work->givenUp = true;
                }
                drawn.seconds = secondsOf(watch);
                drawn_.put(std::move(drawn));
            }
            work->scene.reset();
            drawn_.put({work});
        }
    }

    job::DrawnView drawView(const Work& work, std::size_t i) {
        const Plan& plan = work.plan;
        return job::draw(plan.job, plan.views[i], work.framed[i], *work.scene, renderer_.of(plan.job.settings.backend));
    }

    Agreement scoreOf(const Work& work, const job::DrawnView& drawn, const FramedView& framed) {
        RenderSettings settings = drawn.settings;
        settings.detector = {};
        settings.shade = {};
        settings.lines.hidden = HiddenLines::None;
        const auto linesFrom = [&](LinesFrom from) {
            settings.lines.from = from;
            return renderer_.of(work.plan.job.settings.backend).lines(*work.scene, framed.camera, settings);
        };
        const Lines ofImage = linesFrom(LinesFrom::Image);
        return agreementOf(ofImage, linesFrom(LinesFrom::Object));
    }

    void write() {
        while (true) {
            Drawn drawn = drawn_.take();
            const base::Stopwatch watch;
            Work& work = *drawn.work;
            if (drawn.failure) work.failure = drawn.failure;
            if (work.failure) work.givenUp = true;
            try {
                if (!work.failure) drawn.drawn ? writeView(work, drawn) : work.files->finish();
            } catch (...) {
                work.failure = std::current_exception();
                work.givenUp = true;
            }
            work.result.seconds += drawn.seconds + secondsOf(watch);
            if (!drawn.drawn && !drawn.failure) answer(work);
        }
    }

    void writeView(Work& work, const Drawn& of) {
        const View& view = *of.view;
        const job::DrawnView& drawn = *of.drawn;
        if (!work.files) work.files.emplace(planner_, work.plan, work.item.id, work.result.key);
        const auto add = [&](const std::filesystem::path& name, std::span<const std::uint8_t> bytes) {
            work.result.files.push_back((work.item.id / name).string());
            work.files->add(name, bytes);
        };
        const ViewFiles named{work.result.model, view.name, job::encode(drawn, work.plan.job, view, add)};
        const LineLengths lengths = drawn.maps ? drawn.maps->lengths : lines::lengthsOf(drawn.lines->lines);
        for (std::size_t i = 0; i < lengths.size(); ++i) work.result.lengths[i] += lengths[i];
        if (of.score) (work.result.score ? *work.result.score : work.result.score.emplace()) += *of.score;
        for (const std::string& warning : drawn.maps ? drawn.maps->warnings : drawn.lines->warnings)
            if (std::ranges::find(work.result.warnings, warning) == work.result.warnings.end())
                work.result.warnings.push_back(warning);

        Json camera = job::metadataOf(drawn, work.plan.job, named);
        camera.erase("backend");  // what differs from run to run stands in no file
        camera.erase("milliseconds");
        Json json = work.facts;
        json.update(camera);
        json["lengths"] = lengthsJson(lengths);
        const std::string text = io::textOf(json, -1) + '\n';
        add(cameraFileOf(view), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        work.files->finishView();
    }

    static void answer(Work& work) {
        Result& result = work.result;
        work.files.reset();
        Reply reply = Reply::Done;
        if (work.failure) {
            setFailure(result, work.failure);
            if (isOfContext(work.failure)) reply = Reply::NoContext;
            result.files.clear();
            result.lengths = {};
        }
        process::sendMessage(packed(reply, result.state, reply == Reply::Done ? lineOf(result) : result.error));
    }

    const Planner planner_;
    Channel<WorkPointer> loaded_{1};
    Channel<Drawn> drawn_{2};
    job::OwnRenderer renderer_;
};

}  // namespace

void work() {
    process::becomeDependent();
    // Who interrupts the batch may interrupt its processes, too; this one ends with the one that started it.
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) ::signal(signal, SIG_IGN);
    Worker{process::givenText()}.run();
}

}  // namespace inkedge::batch
