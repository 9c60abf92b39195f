// Models, views and outputs: what is drawn, written, told of and left out.
#include <atomic>
#include <map>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <utility>

#include <nlohmann/json.hpp>

#include <inkedge/job.h>
#include <inkedge/load_scene.h>
#include <inkedge/renderer.h>
#include <inkedge/write.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "gl/gl_test.h"

namespace inkedge::job {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string asset(const std::string& name) { return INKEDGE_SOURCE_DIR "/assets/" + name; }

class RunJobs : public gl_test::OnEachBackend {
protected:
    Job job(const std::string& model, const std::vector<std::string>& outputs, int views = 1) const {
        Job job{.model = asset(model)};
        for (const std::string& output : outputs) job.outputs.push_back(folder_ / output);
        job.settings.picture.size = {48, 32};
        job.settings.lines.from = LinesFrom::Image;
        job.settings.backend.backend = GetParam();
        if (views > 1) job.views = viewsOf("turntable:" + std::to_string(views), job.settings.camera);
        return job;
    }

    TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Backends, RunJobs, testing::Values(Backend::Egl, Backend::Osmesa), gl_test::nameOfInstance);

TEST_P(RunJobs, writeWhatARendererDraws) {
    Job one = job("cube.glb", {"{view}.png", "{view}.svg"}, 2);
    one.settings.maps = {Map::Depth};
    one.metadata = folder_ / "{view}.json";
    std::map<std::size_t, JobResult> results;
    runJobs({&one, 1}, {.finished = [&](const JobResult& result) { results[result.view] = result; }});
    EXPECT_THAT(folder_.names(), ElementsAre("000.depth.png", "000.json", "000.png", "000.svg", "001.depth.png",
                                             "001.json", "001.png", "001.svg"));
    ASSERT_EQ(results.size(), 2U);
    EXPECT_THAT(results[1].files, ElementsAre(folder_ / "001.png", folder_ / "001.depth.png", folder_ / "001.svg"));
    EXPECT_EQ(results[1].metadata, contents(folder_ / "001.json"));

    Settings settings = one.settings;
    settings.camera = one.views[1].camera;
    const Scene scene = loadScene(one.model);
    const Camera camera = frameCamera(scene, settings.camera, settings.picture.size);
    Renderer renderer{settings.backend};
    (void)writeMaps(renderer.render(scene, camera, settings), {}, folder_ / "expected.png");
    EXPECT_EQ(contents(folder_ / "001.png"), contents(folder_ / "expected.png"));
    writeLines(renderer.lines(scene, camera, settings), settings, folder_ / "001.svg.expected.svg");
    EXPECT_EQ(contents(folder_ / "001.svg").size() + std::string_view{".svg.expected"}.size(),
              contents(folder_ / "001.svg.expected.svg").size());  // the title is the file's name
}

TEST_P(RunJobs, loadEachModelOnceWhoeverDrawsIt) {
    const std::vector<Job> jobs{job("cube.glb", {"{model}{view}.png"}, 8), job("gear.glb", {"{model}{view}.png"}, 8)};
    std::vector<std::size_t> loaded;
    std::set<std::pair<std::size_t, std::size_t>> finished;
    std::vector<std::size_t> ended;
    std::size_t withLoading = 0;
    JobOptions options{.workers = 3};
    options.loaded = [&](std::size_t number, const Scene& scene) {
        loaded.push_back(number);
        EXPECT_EQ(scene.triangleCount() == 12, number == 0);
    };
    options.finished = [&](const JobResult& result) {
        finished.insert({result.job, result.view});
        if (result.times.front().stage == "load") ++withLoading;
        EXPECT_EQ(result.times.front().stage == "load", result.view == 0);
    };
    options.progress = [&](std::size_t count, std::size_t views) {
        ended.push_back(count);
        EXPECT_EQ(views, 16U);
    };
    runJobs(jobs, options);
    EXPECT_THAT(loaded, testing::UnorderedElementsAre(0, 1));
    EXPECT_EQ(finished.size(), 16U);
    EXPECT_EQ(withLoading, 2U);
    ASSERT_EQ(ended.size(), 16U);
    EXPECT_TRUE(std::ranges::is_sorted(ended));
    EXPECT_EQ(ended.back(), 16U);
    EXPECT_EQ(folder_.names().size(), 16U);
}

TEST_P(RunJobs, areTheSameHoweverManyWorkers) {
    const auto pictures = [&](int workers) {
        const Job each = job("torus_knot.glb", {"{view}.png"}, 12);
        runJobs({&each, 1}, {.workers = workers});
        std::vector<std::string> all;
        for (const std::string& name : folder_.names()) all.push_back(contents(folder_ / name));
        return all;
    };
    const auto alone = pictures(1);
    EXPECT_EQ(alone.size(), 12U);
    EXPECT_EQ(std::set<std::string>(alone.begin(), alone.end()).size(), 12U);
    EXPECT_EQ(pictures(3), alone);
}

TEST_P(RunJobs, handOverPicturesOfNoFile) {
    Job job = this->job("cube.glb", {});
    job.metadata = folder_ / "m.json";
    Size size;
    runJobs({&job, 1}, {.drawn = [&](std::size_t, std::size_t, const Maps& maps) {
                EXPECT_THAT(folder_.names(), IsEmpty()) << "metadata are written after it";
                size = maps.picture.size();
            }});
    EXPECT_EQ(size, job.settings.picture.size);
    EXPECT_THAT(folder_.names(), ElementsAre("m.json"));
}

TEST_P(RunJobs, drawASceneThatIsThere) {
    Job given = job("none.glb", {"{model}.png"});
    given.scene = loadScene(asset("cube.glb"));
    runJobs({&given, 1});
    EXPECT_THAT(folder_.names(), ElementsAre("none.png"));
}

TEST_P(RunJobs, endWithTheFirstFailure) {
    std::vector<Job> jobs{job("cube.glb", {"a{view}.png"}, 2), job("gear.glb", {"b.png"})};
    jobs[0].views[1].camera.index = 7;
    expectError(Error::Kind::Usage, HasSubstr("camera-index"), [&] { runJobs(jobs); });
    EXPECT_THAT(folder_.names(), ElementsAre("a000.png"));
}

TEST_P(RunJobs, goOnAfterFailuresThatAreTakenNoteOf) {
    std::vector<Job> jobs{job("none.glb", {"a{view}.png"}, 2), job("cube.glb", {"b{view}.png"}, 2),
                          job("gear.glb", {"c.png"})};
    jobs[1].views[0].camera.index = 7;
    std::vector<std::pair<std::size_t, std::optional<std::size_t>>> failed;
    std::size_t last = 0;
    JobOptions options{.failed = [&](const JobFailure& failure) {
        failed.emplace_back(failure.job, failure.view);
        EXPECT_THROW(std::rethrow_exception(failure.error), Error);
    }};
    options.progress = [&](std::size_t ended, std::size_t) { last = ended; };
    runJobs(jobs, options);
    EXPECT_THAT(failed, ElementsAre(std::pair{std::size_t{0}, std::optional<std::size_t>{}},
                                    std::pair{std::size_t{1}, std::optional<std::size_t>{0}}));
    EXPECT_EQ(last, 5U);
    EXPECT_THAT(folder_.names(), ElementsAre("b001.png", "c.png"));
}

TEST_P(RunJobs, endWithWhatTheCallerThrows) {
    const Job each = job("cube.glb", {"{view}.png"}, 3);
    JobOptions options{.finished = [](const JobResult&) { throw std::runtime_error{"enough"}; }};
    options.failed = [](const JobFailure&) { ADD_FAILURE() << "not a view's failure"; };
    EXPECT_THROW(runJobs({&each, 1}, options), std::runtime_error);
    EXPECT_THAT(folder_.names(), ElementsAre("000.png"));
}

TEST_P(RunJobs, doNothingOnceAskedToStop) {
    std::stop_source source;
    source.request_stop();
    const Job each = job("cube.glb", {"a.png"});
    JobOptions options{.stop = source.get_token()};
    options.loaded = [](std::size_t, const Scene&) { ADD_FAILURE() << "expected no model to be read"; };
    expectError(Error::Kind::Stopped, HasSubstr("found a request to stop"), [&] { runJobs({&each, 1}, options); });
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_P(RunJobs, endWhenAskedToStopWithTheFilesOfWholeViews) {
    for (const int workers : {1, 3}) {
        std::stop_source source;
        std::set<std::filesystem::path> written;
        std::size_t ended = 0;
        Job each = job("gear.glb", {"{view}.png"}, 40);
        each.settings.maps = {Map::Depth};
        JobOptions options{.workers = workers, .stop = source.get_token()};
        options.finished = [&](const JobResult& result) {
            written.insert(result.files.begin(), result.files.end());
            if (++ended == 5) source.request_stop();
        };
        options.failed = [](const JobFailure&) { ADD_FAILURE() << "a view that was given up has not failed"; };
        expectError(Error::Kind::Stopped, HasSubstr("found a request to stop"), [&] { runJobs({&each, 1}, options); });
        EXPECT_GE(ended, 5U);
        EXPECT_LT(ended, 5U + static_cast<std::size_t>(workers));
        std::set<std::filesystem::path> found;
        for (const std::string& name : folder_.names()) found.insert(folder_ / name);
        EXPECT_EQ(found, written) << "no file of a view that was given up, none half-written";
        for (const auto& file : found) std::filesystem::remove(file);
    }
}

TEST_P(RunJobs, refuseACountOfWorkers) {
    const Job each = job("cube.glb", {"a.png"});
    for (const int workers : {-1, 1025})
        expectError(Error::Kind::Usage, HasSubstr("workers: expected 0 to 1024, found "), [&] {
            runJobs({&each, 1}, {.workers = workers});
        });
    EXPECT_THAT(folder_.names(), IsEmpty());
}

}  // namespace
}  // namespace inkedge::job
