// What is refused before any work, and where files go.
#include <gmock/gmock.h>

#include <inkedge/job.h>
#include <inkedge/setting_table.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"

namespace inkedge::job {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Kind = Error::Kind;

class CheckJobs : public testing::Test {
protected:
    Job job(const std::vector<std::string>& outputs, const std::string& model = "gear.glb") const {
        Job job{.model = "models/" + model};
        for (const std::string& output : outputs) job.outputs.push_back(folder_ / output);
        return job;
    }
    static std::vector<View> views(const std::vector<std::string>& names) {
        std::vector<View> views;
        for (const std::string& name : names) views.push_back({name, {}});
        return views;
    }
    static void expectRefused(Kind kind, const std::vector<Job>& jobs, const std::string& text) {
        expectError(kind, HasSubstr(text), [&] { checkJobs(jobs); });
    }

    TemporaryFolder folder_;
};

TEST_F(CheckJobs, takesSeveralModelsViewsAndOutputs) {
    std::vector<Job> jobs{job({"{model}_{view}.png", "{model}_{view}.svg"}, "a.glb"),
                          job({"{model}_{view}.png", "{model}_{view}.svg"}, "b.glb")};
    for (Job& each : jobs) each.views = views({"front", "back"});
    EXPECT_NO_THROW(checkJobs(jobs));
    EXPECT_THAT(folder_.names(), testing::IsEmpty());
}

TEST_F(CheckJobs, filesAreNamedAfterModelViewAndMap) {
    Job named = job({"{model}_{view}_{map}.png", "{view}{view}.{map}.svg"});
    named.metadata = "{model}.{view}.json";
    named.settings.maps = {Map::Depth, Map::Depth};
    EXPECT_THAT(filesOf(named, {"iso", {}}),
                ElementsAre(folder_ / "gear_iso_outline.png", folder_ / "gear_iso_depth.png",
                            folder_ / "isoiso.outline.svg", "gear.iso.json"));
    EXPECT_THAT(filesOf(job({}), {"iso", {}}), testing::IsEmpty());
}

TEST_F(CheckJobs, refusesASetting) {
    Job wrong = job({"a.png"});
    wrong.settings.style.sumiWidth = -5.0;
    expectRefused(Kind::Usage, {wrong}, "sumi-width");
}

TEST_F(CheckJobs, refusesFilesThatCannotBeWritten) {
    expectRefused(Kind::Usage, {job({"a.jpg"})}, "a.jpg");
    expectRefused(Kind::Output, {job({"a.png", "none/a.png"})},
                  "none/a.png: cannot be written: expected a folder " + (folder_ / "none").string() + ", found none");
    put(folder_ / "file", "");
    expectRefused(Kind::Output, {job({"file/a.svg"})}, "found a file in its way");
    Job withMetadata = job({"a.png"});
    withMetadata.metadata = folder_ / "none/a.json";
    expectRefused(Kind::Output, {withMetadata}, "none/a.json: cannot be written");
}

TEST_F(CheckJobs, refusesViewsWithoutFilesOfTheirOwn) {
    Job several = job({"{view}.png", "a.png"});
    several.views = views({"0", "1"});
    expectRefused(Kind::Usage, {several}, "--output: expected {view} in it for 2 views, found '");
    several.outputs.pop_back();
    EXPECT_NO_THROW(checkJobs({&several, 1}));
    several.views[1].name = "0";
    expectRefused(Kind::Usage, {several}, "0.png: expected a file for view 0 of models/gear.glb alone, found it asked");
}

TEST_F(CheckJobs, takesOneFileOfMetadataForAllViews) {
    Job several = job({"{view}.png"});
    several.views = views({"0", "1"});
    several.metadata = folder_ / "all.json";
    EXPECT_NO_THROW(checkJobs({&several, 1}));
    Job other = job({"other_{view}.png"}, "other.glb");
    other.views = several.views;
    other.metadata = several.metadata;
    expectRefused(Kind::Usage, {several, other},
                  "all.json: expected a file for all views of models/gear.glb alone, found it asked for by all views "
                  "of models/other.glb too; put {model} and {view} in its name");
    for (const char* view : {"0.png", "1.png"}) {
        several.metadata = folder_ / view;
        expectRefused(Kind::Usage, {several}, std::string{view} + ": expected a file for ");
    }
    several.metadata = folder_ / "none/all.json";
    expectRefused(Kind::Output, {several}, "none/all.json: cannot be written");
}

TEST_F(CheckJobs, refusesModelsThatShareAFile) {
    expectRefused(Kind::Usage, {job({"{view}.png"}, "a.glb"), job({"{view}.png"}, "b.glb")},
                  "0.png: expected a file for view 0 of models/a.glb alone, found it asked for by view 0 of "
                  "models/b.glb too; put {model} and {view} in its name");
    expectRefused(Kind::Usage, {job({"{model}.png"}, "x/a.glb"), job({"{model}.png"}, "y/a.obj")}, "a.png: ");
}

TEST_F(CheckJobs, refusesAnotherJobsModelAsOutput) {
    put(folder_ / "b.glb", "");
    std::filesystem::create_hard_link(folder_ / "b.glb", folder_ / "a.png");
    Job second = job({"c.png"});
    second.model = folder_ / "b.glb";
    expectRefused(Kind::Usage, {job({"{model}.png"}, "a.glb"), second},
                  "a.png: expected an output other than what is read, found the model " + second.model.string());
}

TEST_F(CheckJobs, refusesNamesThatLeadOutOfTheFolder) {
    for (const std::string& name : std::vector<std::string>{"..", ".", "a/b", "../a", {"a\0b", 3}}) {
        Job named = job({"{view}/a.png"});
        std::filesystem::create_directories(folder_ / "a/b");
        named.views = views({name});
        expectRefused(Kind::Usage, {named}, "expected a name for {view} that stays in the folder, found '");
    }
    Job unnamed = job({"{model}/a.png"}, "");
    unnamed.model.clear();
    unnamed.outputs = {"{model}/a.png"};
    expectRefused(Kind::Usage, {unnamed}, "expected a name for {model} that stays in the folder, found ''");
}

TEST_F(CheckJobs, refusesLinksToNothing) {
    std::filesystem::create_symlink("gone", folder_ / "a.png");
    expectRefused(Kind::Output, {job({"a.png"})},
                  "a.png: cannot be written: expected a file behind the link, found none");
}

TEST_F(CheckJobs, refusesWhatIsNoLineInFilesOfLines) {
    const auto refuse = [&](const std::string& name, const std::string& text) {
        Job lines = job({"a.svg"});
        set(lines.settings, name, text, "test");
        expectRefused(Kind::Usage, {lines}, "--" + name + ": expected a picture as --output, found ");
    };
    refuse("maps", "depth");
    refuse("style", "hatch");
    refuse("function", "curvature");
    refuse("brush", "brush.png");
    Job both = job({"a.svg", "a.png"});
    both.settings.maps = {Map::Depth};  // the picture's
    EXPECT_NO_THROW(checkJobs({&both, 1}));
}

}  // namespace
}  // namespace inkedge::job
