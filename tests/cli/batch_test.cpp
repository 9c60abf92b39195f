// inkedge batch: what it draws, what it says of it, and how it goes on.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "cli/command.h"

namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class BatchTest : public Command {
protected:
    /// inkedge batch INPUT -o out, 32 x 32, and these.
    Outcome batch(const std::string& input, const Arguments& more = {}) const {
        Arguments arguments{"batch", input, "-o", "out", "--size", "32x32"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    /// A file of items; each a path, or JSON.
    std::string list(const std::vector<std::string>& lines) const {
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        return file("list.jsonl", text);
    }
    static std::string item(const std::string& model, const std::string& id) {
        return json{{"model", model}, {"id", id}}.dump();
    }

    /// The lines of the results by id.
    std::map<std::string, json> results() const {
        std::istringstream lines{contents(folder_ / "out/results.jsonl")};
        std::map<std::string, json> all;
        for (std::string line; std::getline(lines, line);) {
            const json result = json::parse(line);
            EXPECT_TRUE(all.emplace(result["id"], result).second) << "a second line of " << result["id"];
        }
        return all;
    }
    std::map<std::string, std::string> states() const {
        std::map<std::string, std::string> all;
        for (const auto& [id, result] : results()) all[id] = result["state"];
        return all;
    }

    /// Every file in the output by its path, hidden ones, too; of results, what is the same from run to run.
    std::map<std::string, std::string> everything(const std::string& folder = "out") const {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator{folder_ / folder}) {
            if (!entry.is_regular_file()) continue;
            const std::string name = entry.path().lexically_relative(folder_ / folder);
            files[name] = name == "results.jsonl" ? comparable(contents(entry.path())) : contents(entry.path());
        }
        return files;
    }

private:
    static std::string comparable(const std::string& results) {
        std::istringstream stream{results};
        std::multiset<std::string> lines;
        for (std::string line; std::getline(stream, line);) {
            json result = json::parse(line);
            result.erase("seconds");
            lines.insert(result.dump());
        }
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        return text;
    }
};

TEST_F(BatchTest, DrawsEveryModelOfAFolder) {
    std::filesystem::create_directories(models_ / "set/a");
    std::filesystem::copy_file(asset("cube.glb"), models_ / "set/a/cube.glb");
    std::filesystem::copy_file(asset("bracket.glb"), models_ / "set/bracket.glb");
    put(models_ / "set/damaged.stl", "solid nothing");
    const Outcome outcome = batch(models_ / "set", {"--views", "turntable:2", "--maps", "depth,ids"});
    EXPECT_EQ(outcome.exitCode, 1) << "one failed";
    EXPECT_THAT(outcome.out, StartsWith("3 items: 2 drawn, 1 failed (1 refused) in 0:00:"));
    EXPECT_THAT(outcome.error, AllOf(StartsWith("inkedge: error: damaged.stl: "), HasSubstr("expected ")));

    const auto all = results();
    ASSERT_EQ(all.size(), 3U);
    const json& cube = all.at("a/cube.glb");
    EXPECT_EQ(cube["state"], "drawn");
    EXPECT_EQ(cube["model"], (models_ / "set/a/cube.glb").string());
    EXPECT_EQ(cube["triangles"], 12);
    EXPECT_EQ(cube["error"], nullptr);
    EXPECT_EQ(cube["warnings"], json::array());
    EXPECT_GT(cube["seconds"], 0.0);
    EXPECT_GT(cube["lengths"]["outline"], 40.0) << "two pictures of 32 pixels";
    EXPECT_EQ(all.at("damaged.stl")["files"], json::array());
    EXPECT_THAT(std::string{all.at("damaged.stl")["error"]}, HasSubstr("expected "));

    std::vector<std::string> names;
    for (const auto& [name, content] : everything())
        if (name.starts_with("a/")) names.push_back(name);
    std::vector<std::string> said = cube["files"];
    std::ranges::sort(said);
    EXPECT_EQ(names, said);
    EXPECT_THAT(
        names,
        ElementsAre("a/cube.glb/000.depth.png", "a/cube.glb/000.ids-across.png", "a/cube.glb/000.ids-material.png",
                    "a/cube.glb/000.ids-object.png", "a/cube.glb/000.ids-patch.png", "a/cube.glb/000.json",
                    "a/cube.glb/000.outline.png", "a/cube.glb/001.depth.png", "a/cube.glb/001.ids-across.png",
                    "a/cube.glb/001.ids-material.png", "a/cube.glb/001.ids-object.png", "a/cube.glb/001.ids-patch.png",
                    "a/cube.glb/001.json", "a/cube.glb/001.outline.png"));
}

// The second waits for the first to be drawn.
TEST_F(BatchTest, CountsTheSecondsOfWorkOnAnItemAlone) {
    const json large = {{"id", "large"},
                        {"model", asset("bracket.glb")},
                        {"settings", {{"size", "512x512"}, {"supersampling", 4}}}};
    expectSuccess(batch(list({large.dump(), item(asset("cube.glb"), "small")}), {"--jobs", "1"}));
    const double seconds = results().at("large")["seconds"];
    EXPECT_LT(results().at("small")["seconds"], 0.5 * seconds);
}

TEST_F(BatchTest, WritesWhatRenderWrites) {
    const std::string model = asset("bracket.glb");
    const Arguments flags{"--views", "sphere:3", "--maps", "depth,types", "--lines-from", "image"};
    expectSuccess(batch(list({item(model, "b")}), flags));
    Arguments render{"render", model, "-o", "{view}.{map}.png", "--size", "32x32", "--metadata", "{view}.json"};
    render.insert(render.end(), flags.begin(), flags.end());
    expectSuccess(run(render));
    for (const std::string view : {"000", "001", "002"}) {
        for (const std::string map : {"outline", "depth", "types"}) {
            const std::string name = view + "." + map + ".png";
            EXPECT_EQ(contents(folder_ / "out/b" / name), contents(folder_ / name)) << name;
        }
        const json ofBatch = json::parse(contents(folder_ / "out/b" / (view + ".json")));
        const json ofRender = json::parse(contents(folder_ / (view + ".json")));
        for (const char* key : {"model", "view", "camera", "size", "depth_png", "bounds", "up", "triangles"})
            EXPECT_EQ(ofBatch.at(key), ofRender.at(key)) << key;
        EXPECT_EQ(ofBatch["id"], "b");
        EXPECT_GT(ofBatch["lengths"]["outline"], 10.0);
        EXPECT_EQ(ofBatch["camera"]["K"].size(), 3U);
    }
}

TEST_F(BatchTest, TakesIdsViewsAndSettingsOfItems) {
    const std::string input =
        list({asset("cube.glb"), json{{"model", asset("cube.glb")},
                                      {"id", "own/x"},
                                      {"views", "front,random:2:5"},
                                      {"settings", {{"size", "20x10"}, {"maps", "depth"}, {"dpi", nullptr}}}}
                                     .dump()});
    expectSuccess(batch(input, {"--formats", "png,svg"}));
    const auto all = results();
    const std::string ofPath = asset("cube.glb").substr(1);
    EXPECT_EQ(all.at(ofPath)["files"],
              json({ofPath + "/0.outline.png", ofPath + "/0.outline.svg", ofPath + "/0.json"}));
    EXPECT_EQ(all.at("own/x")["files"],
              json({"own/x/front.outline.png", "own/x/front.depth.png", "own/x/front.outline.svg", "own/x/front.json",
                    "own/x/000.outline.png", "own/x/000.depth.png", "own/x/000.outline.svg", "own/x/000.json",
                    "own/x/001.outline.png", "own/x/001.depth.png", "own/x/001.outline.svg", "own/x/001.json"}));
    EXPECT_EQ(json::parse(contents(folder_ / "out/own/x/front.json"))["size"], json({20, 10}));
    EXPECT_EQ(json::parse(contents(folder_ / "out/batch.json"))["settings"]["size"], "32x32");
}

TEST_F(BatchTest, SaysOfEveryBadLineWhatIsWrong) {
    const std::string cube = asset("cube.glb");
    const Outcome outcome = batch(
        list({item(cube, "good"), "{nothing", R"({"model": "a.stl", "id": "../out"})", item(cube, "good"),
              R"({"model": "missing.stl"})", json{{"model", cube}, {"id", "s"}, {"settings", {{"size", "0"}}}}.dump(),
              json{{"model", cube}, {"id", "n"}, {"settings", {{"no-setting", 1}}}}.dump(),
              json{{"model", cube}, {"id", "v"}, {"views", "turntable:0"}}.dump()}));
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, StartsWith("8 items: 1 drawn, 7 failed (4 refused, 3 no items)"));
    const std::string where = (models_ / "list.jsonl").string();
    for (const std::string& message :
         {where + ":2: expected JSON, found something else at byte ",
          where + ":3: id: expected names with / between them, none of which begins with a dot, found one that begins "
                  "with a dot in '../out'",
          cube + ": id: expected one of its own, found 'good' again",
          std::string{"missing.stl: missing.stl: expected a file, found none"},
          std::string{"s: settings: size: expected "}, std::string{"n: settings: no-setting: there is no setting"},
          std::string{"v: --views: expected a number of views from 1"}})
        EXPECT_THAT(outcome.error, HasSubstr("inkedge: error: " + message));
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 7);
    EXPECT_EQ(states().size(), 5U) << "lines that are no items have no result";
    EXPECT_THAT(batch(models_ / "list.jsonl", {"-q"}).error, IsEmpty());
}

TEST_F(BatchTest, RefusesWhatCannotBeDoneAtAll) {
    const std::string good = list({item(asset("cube.glb"), "a")});
    expectFailure(batch("missing"), 3, HasSubstr("missing: expected a folder of models or a file with an item a line"));
    expectFailure(batch(asset("cube.glb")), 2, HasSubstr("found a model; inkedge render draws it"));
    expectFailure(batch(good, {"--views", "turntable:0"}), 2, HasSubstr("--views: "));
    expectFailure(batch(good, {"--formats", "gif"}), 2, HasSubstr("gif"));
    expectFailure(batch(good, {"--formats", "svg", "--maps", "depth"}), 2, HasSubstr("--maps: expected a picture"));
    expectFailure(batch(good, {"--formats", "png,png"}), 2, HasSubstr("asked for by"));
    expectFailure(batch(good, {"--shards", "many"}), 2, HasSubstr("--shards: expected a number of items, or of MB"));
    expectFailure(batch(good, {"--shards", "0"}), 2, HasSubstr("--shards: expected "));
    expectFailure(batch(good, {"--max-memory", "3"}), 2, HasSubstr("--max-memory: expected a number of MB or GB"));
    expectFailure(batch(good, {"--jobs", "0"}), 2, HasSubstr("--jobs: expected "));
    put(models_ / "views.json", R"([{"name": "a.b", "azimuth": 3}])");
    expectFailure(batch(good, {"--shards", "5", "--views", models_ / "views.json"}), 2,
                  HasSubstr("--shards: expected views without a dot in their names, found 'a.b'"));
    put(folder_ / "file", "x");
    expectFailure(run({"batch", good, "-o", "file"}), 5, HasSubstr("file: cannot be written: expected a folder"));
    expectFailure(run({"batch", good, "-o", "file/out"}), 5, HasSubstr("cannot be written: expected a folder"));
    expectFailure(run({"batch", ".", "-o", "."}), 2, HasSubstr("expected a folder other than that of the models"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out/a"));
}

TEST_F(BatchTest, ReadsItemsFromStdin) {
    const std::string input = list({item(asset("cube.glb"), "a")});
    const Outcome outcome = Running{
        INKEDGE_COMMAND, {"batch", "-", "-o", "out", "--size", "16x16"}, folder_.path(), {}, [&] {
            ::dup2(::open(input.c_str(), O_RDONLY | O_CLOEXEC), STDIN_FILENO);
        }}.finish();
    expectSuccess(outcome);
    EXPECT_EQ(states(), (std::map<std::string, std::string>{{"a", "drawn"}}));
}

// --- once more

TEST_F(BatchTest, DrawsOnlyWhatIsMissing) {
    const std::string cube = file("cube.glb", contents(asset("cube.glb")));
    const std::string input = list({item(cube, "cube"), item(asset("bracket.glb"), "bracket"), item(roof(), "roof"),
                                    item(file("bad.stl", "solid x"), "bad")});
    EXPECT_EQ(batch(input).exitCode, 1);
    const auto first = everything();
    const auto again = [&](const std::string& counts, const Arguments& more = {}) {
        const Outcome outcome = batch(input, more);
        EXPECT_THAT(outcome.out, StartsWith("4 items: " + counts));
        EXPECT_EQ(results().size(), 4U);
        return outcome;
    };
    EXPECT_EQ(again("0 drawn, 3 drawn before, 1 failed (1 refused)").exitCode, 1);
    EXPECT_EQ(everything(), first);

    std::filesystem::remove(folder_ / "out/cube/0.outline.png");
    again("1 drawn, 2 drawn before");
    EXPECT_EQ(everything(), first);

    std::filesystem::copy_file(asset("bracket.glb"), cube, std::filesystem::copy_options::overwrite_existing);
    again("1 drawn, 2 drawn before");
    EXPECT_EQ(contents(folder_ / "out/cube/0.outline.png"), contents(folder_ / "out/bracket/0.outline.png"));
    // A glTF's buffer is in another file.
    put(models_ / "roof.bin", contents(models_ / "roof.bin").replace(0, 1, "\x01"));
    again("1 drawn, 2 drawn before");

    again("3 drawn, 1 failed", {"--line-width", "3"});
    again("0 drawn, 3 drawn before", {"--line-width", "3", "--backend", "auto", "--max-vertices", "1M"});
    again("0 drawn, 3 drawn before, 1 failed (1 refused)", {"--line-width", "3", "--retry"});
    put(models_ / "bad.stl", contents(asset("cube.glb")));
    EXPECT_EQ(again("1 drawn, 3 drawn before", {"--line-width", "3"}).exitCode, 0);
}

TEST_F(BatchTest, EndsWhenTooManyFail) {
    std::vector<std::string> lines;
    for (int i = 0; i < 40; ++i) lines.push_back("missing" + std::to_string(i) + ".stl");
    const Outcome outcome = batch(list(lines), {"--max-failures", "3", "--jobs", "1", "-q"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, HasSubstr("expected at most 3 failures, found "));
    EXPECT_LE(results().size(), 6U) << "what was under way is finished";
    expectSuccess(run({"batch", list({item(roof(), "a")}), "-o", "all", "--max-failures", "0", "--size", "8x8"}));
}

// --- shards

std::string tarfile(const std::filesystem::path& folder, const std::string& code) {
    const Outcome outcome = runCommand("/usr/bin/env", {"python3", "-c", "import tarfile, json, sys\n" + code}, folder);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    return outcome.out;
}

// The variables of a task of Slurm, as of --array=1-3:2.
Environment arrayTask(const std::string& id) {
    return {{"SLURM_ARRAY_TASK_ID", id},
            {"SLURM_ARRAY_TASK_MIN", "1"},
            {"SLURM_ARRAY_TASK_MAX", "3"},
            {"SLURM_ARRAY_TASK_COUNT", "2"},
            {"SLURM_ARRAY_TASK_STEP", "2"}};
}

TEST_F(BatchTest, TasksDrawTheirShardsAndTheGalleryShowsAll) {
    std::vector<std::string> items;
    for (const char* id : {"a", "b", "c", "d", "e", "f"}) items.push_back(item(asset("cube.glb"), id));
    const Arguments arguments{"batch", list(items), "-o", "out", "--size", "8x8"};
    std::size_t drawn = 0;
    for (const auto& [id, shard] : {std::pair{"1", "0"}, {"3", "1"}}) {
        const Outcome outcome = run(arguments, arrayTask(id));
        expectSuccess(outcome);
        EXPECT_THAT(outcome.error, HasSubstr(std::string{"items of shard "} + shard + "/2\n"));
        drawn += std::stoul(outcome.out);
    }
    EXPECT_EQ(drawn, items.size());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out/results.jsonl"));
    EXPECT_THAT(run({"gallery", "out"}).out, HasSubstr(": 6 items"));
    EXPECT_THAT(run(arguments, arrayTask("3")).out, HasSubstr(" 0 drawn, ")) << "a task that is started again";
    EXPECT_THAT(run(arguments).out, StartsWith("6 items: 0 drawn, 6 drawn before")) << "by the tasks";
    EXPECT_EQ(states().size(), 6U);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out/results.0-of-2.jsonl"));

    expectFailure(run(arguments, arrayTask("2")), 2, HasSubstr("give --shard I/N"));
    expectFailure(batch("list.jsonl", {"--shard", "2/2"}), 2, HasSubstr("--shard: expected I/N"));
}

TEST_F(BatchTest, TasksHaveShardsOfTheirOwn) {
    std::vector<std::string> items;
    for (const char* id : {"a", "b", "c", "d", "e", "f"}) items.push_back(item(asset("cube.glb"), id));
    const std::string input = list(items);
    const auto task = [&](const std::string& shard) {
        return batch(input, {"--shard", shard, "--shards", "100", "-q"});
    };
    expectSuccess(task("0/2"));
    expectSuccess(task("1/2"));
    std::vector<std::string> names;
    for (const auto& [name, content] : everything()) names.push_back(name);
    EXPECT_THAT(names, ElementsAre("0-of-2.000000.tar", "1-of-2.000000.tar", "batch.json", "results.0-of-2.jsonl",
                                   "results.1-of-2.jsonl"));
    const json members = json::parse(tarfile(folder_ / "out", R"(
names = [name for shard in (0, 1) for name in tarfile.open(f"{shard}-of-2.000000.tar").getnames()]
print(json.dumps(sorted(name.split("/")[0] for name in names if name.endswith(".json"))))
)"));
    EXPECT_EQ(members, (json{"a", "b", "c", "d", "e", "f"}));
    for (const Outcome& other : {task("0/3"), batch(input, {"--shards", "100", "-q"})})
        expectFailure(other, 2, HasSubstr("--shard: expected the number of tasks that wrote the shards in out"));
    expectFailure(run({"gallery", "out"}), 3, HasSubstr("found shards"));
}

TEST_F(BatchTest, WritesShardsThatOthersRead) {
    const std::string longId = "long/" + std::string(120, 'n') + "/\u00e4.v2";
    const std::string input = list({item(asset("cube.glb"), "a"), item(asset("bracket.glb"), longId), "missing.stl",
                                    item(roof(), "c"), item(asset("cube.glb"), "d")});
    const Arguments flags{"--shards", "3", "--views", "turntable:2", "--maps", "depth", "--jobs", "2"};
    EXPECT_EQ(batch(input, flags).exitCode, 1);
    const TemporaryFolder folders;
    Arguments asFolders{"batch", input, "-o", folders.path(), "--size", "32x32"};
    asFolders.insert(asFolders.end(), flags.begin() + 2, flags.end());
    EXPECT_EQ(run(asFolders).exitCode, 1);

    std::vector<std::string> names;
    for (const auto& [name, content] : everything()) names.push_back(name);
    EXPECT_THAT(names, ElementsAre("000000.tar", "000001.tar", "batch.json", "results.jsonl"));
    // The samples as the webdataset library makes them: what stands before the first dot of a name is its key, and the
    // members of a sample follow each other.
    const json samples = json::parse(tarfile(folder_ / "out", R"(
import itertools, re
def samples(name):
    with tarfile.open(name) as tar:
        members = [(re.match(r"^((?:.*/|)[^.]+)[.]([^/]*)$", m.name).groups(), m) for m in tar]
        for key, group in itertools.groupby(members, key=lambda member: member[0][0]):
            yield key, {extension: tar.extractfile(m).read().hex() for (_, extension), m in group}
print(json.dumps([list(samples(name)) for name in ("000000.tar", "000001.tar")]))
)"));
    std::vector<std::vector<std::string>> keys;
    for (const auto& shard : samples) {
        keys.emplace_back();
        for (const auto& sample : shard) {
            const std::string key = sample[0];
            keys.back().push_back(key);
            EXPECT_EQ(sample[1].size(), 3U);
            for (const auto& [extension, hex] : sample[1].items()) {
                std::string bytes;
                for (std::size_t i = 0; i < hex.get<std::string>().size(); i += 2)
                    bytes += static_cast<char>(std::stoi(hex.get<std::string>().substr(i, 2), nullptr, 16));
                EXPECT_EQ(bytes, contents(folders / (key + "." + extension))) << key << " " << extension;
            }
        }
    }
    EXPECT_THAT(keys, ElementsAre(ElementsAre("a/000", "a/001", longId + "/000", longId + "/001"),
                                  ElementsAre("c/000", "c/001", "d/000", "d/001")));
    EXPECT_EQ(results().at("a")["files"], json({"a/000.outline.png", "a/000.depth.png", "a/000.json",
                                                "a/001.outline.png", "a/001.depth.png", "a/001.json"}));
}

TEST_F(BatchTest, AddsToShards) {
    const std::string late = models_ / "late.glb";
    const std::string input = list({item(asset("cube.glb"), "a"), item(late, "b"), item(asset("bracket.glb"), "c")});
    EXPECT_EQ(batch(input, {"--shards", "2"}).exitCode, 1);
    const std::string second = contents(folder_ / "out/000001.tar");
    std::filesystem::copy_file(asset("cube.glb"), late);
    const Outcome outcome = batch(input, {"--shards", "2"});
    expectSuccess(outcome);
    EXPECT_THAT(outcome.out, StartsWith("3 items: 1 drawn, 2 drawn before, 0 failed"));
    EXPECT_EQ(contents(folder_ / "out/000001.tar"), second);
    EXPECT_EQ(tarfile(folder_ / "out", "print([m.name for m in tarfile.open('000000.tar')])"),
              "['a/0.outline.png', 'a/0.json', 'b/0.outline.png', 'b/0.json']\n");
    expectSuccess(run({"batch", input, "-o", "whole", "--size", "32x32", "--shards", "2"}));
    EXPECT_EQ(everything(), everything("whole"));
}

TEST_F(BatchTest, ScoresHowFarBothSourcesAgree) {
    const std::string items = list({item(asset("cube.glb"), "cube"), item(asset("gear.glb"), "gear")});
    expectSuccess(run({"batch", items, "-o", "out", "--size", "256x256", "--views", "turntable:2", "--score"}));
    for (const auto& [id, result] : results()) {
        const json& score = result.at("score");
        EXPECT_GT(score.at("f1"), 0.97) << id;
        EXPECT_LE(score.at("f1"), 1.0) << id;
        EXPECT_GE(score.at("recall"), 0.95) << id;
    }
    EXPECT_EQ(results().size(), 2U);
}

}  // namespace
