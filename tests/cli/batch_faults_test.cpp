// inkedge batch among items and people that end it: whole files, one line an item, and the same in the end.
#include <dirent.h>

#include <map>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "cli/faults.h"

namespace {

using namespace faults;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::set<pid_t> childrenOf(pid_t process) {
    std::set<pid_t> all;
    const std::string tasks = "/proc/" + std::to_string(process) + "/task";
    std::error_code ignored;
    for (const auto& task : std::filesystem::directory_iterator{tasks, ignored}) {
        std::ifstream children{task.path() / "children"};
        for (pid_t child = 0; children >> child;) all.insert(child);
    }
    return all;
}

class BatchFaults : public Faults {
protected:
    void SetUp() override {
        models_of_batch_ = models_ / "set";
        std::filesystem::create_directory(models_of_batch_);
        for (const char* name : {"bracket", "cube", "gear", "torus_knot"})
            if (std::filesystem::exists(asset(std::string{name} + ".glb")))
                for (const char* copy : {"a", "b", "c"})
                    std::filesystem::copy_file(asset(std::string{name} + ".glb"),
                                               models_of_batch_ / (std::string{copy} + "-" + name + ".glb"));
        put(models_of_batch_ / "damaged.stl", "solid x");
    }

    Arguments batch(const std::string& output, const Arguments& more = {}) const {
        Arguments arguments{"batch", models_of_batch_, "-o",          output,   "--size", "48x48", "--jobs",
                            "2",     "--views",        "turntable:2", "--maps", "depth",  "-q"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    std::vector<json> results(const std::string& output) const {
        std::istringstream lines{contents(folder_ / output / "results.jsonl")};
        std::vector<json> all;
        for (std::string line; std::getline(lines, line);) all.push_back(json::parse(line));
        return all;
    }
    std::map<std::string, std::string> states(const std::string& output) const {
        std::map<std::string, std::string> all;
        for (const json& result : results(output)) EXPECT_TRUE(all.emplace(result["id"], result["state"]).second);
        return all;
    }

    /// Every file by its path; of results what is the same from run to run, in the order of ids.
    std::map<std::string, std::string> everything(const std::string& output) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator{folder_ / output}) {
            const std::string name = entry.path().lexically_relative(folder_ / output);
            if (entry.is_regular_file() && name != "results.jsonl") files[name] = contents(entry.path());
        }
        for (json result : results(output)) {
            result.erase("seconds");
            EXPECT_TRUE(files.emplace("result of " + result["id"].get<std::string>(), result.dump()).second);
        }
        return files;
    }

    // Nothing without its name is left, and every file is whole.
    void expectWhole(const std::string& output) const {
        if (!std::filesystem::exists(folder_ / output)) return;
        for (const auto& entry : std::filesystem::recursive_directory_iterator{folder_ / output}) {
            const std::string name = entry.path().filename();
            EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
            if (name.ends_with(".png")) {
                EXPECT_TRUE(contents(entry.path()).ends_with(std::string("IEND\xae\x42\x60\x82"))) << name;
            } else if (name.ends_with(".json")) {
                EXPECT_TRUE(json::accept(contents(entry.path()))) << name;
            } else if (name.ends_with(".tar") && !name.starts_with(".")) {
                EXPECT_TRUE(contents(entry.path()).ends_with(std::string(1024, '\0'))) << name;
            }
        }
    }

    /// Ends a batch at random moments until it comes to its end, each time as if the machine had.
    void expectSameAfterKills(const Arguments& more, int kills) const {
        expectOne(runWith({}, batch("unbroken", more)));
        const auto unbroken = everything("unbroken");
        std::mt19937 random{std::random_device{}()};
        for (int i = 0; i < kills; ++i) {
            Running running{INKEDGE_COMMAND, batch("broken", more), folder_.path()};
            std::this_thread::sleep_for(std::chrono::milliseconds{std::uniform_int_distribution{50, 900}(random)});
            const std::set<pid_t> workers = childrenOf(running.process());
            ::kill(running.process(), SIGKILL);
            for (const pid_t worker : workers) ::kill(worker, SIGKILL);
            static_cast<void>(running.finish());
            expectWhole("broken");
        }
        expectOne(runWith({}, batch("broken", more)));
        EXPECT_EQ(everything("broken"), unbroken);
    }
    // One of the models is damaged.
    static void expectOne(const Outcome& outcome) { EXPECT_EQ(outcome.exitCode, 1) << outcome.error; }

    std::filesystem::path models_of_batch_;
};

TEST_F(BatchFaults, KillsLeaveFoldersThatAreTheSameInTheEnd) { expectSameAfterKills({}, 8); }

TEST_F(BatchFaults, KillsLeaveShardsThatAreTheSameInTheEnd) { expectSameAfterKills({"--shards", "3"}, 8); }

TEST_F(BatchFaults, KillsLeaveShardsOfASizeThatAreTheSameInTheEnd) { expectSameAfterKills({"--shards", "1MB"}, 4); }

TEST_F(BatchFaults, TwoCopiesMakeOneSet) {
    for (const Arguments& more : {Arguments{}, Arguments{"--shards", "4"}}) {
        const std::string of = more.empty() ? "folders" : "shards";
        expectOne(runWith({}, batch("unbroken-" + of, more)));
        Running one{INKEDGE_COMMAND, batch(of, more), folder_.path()};
        Running other{INKEDGE_COMMAND, batch(of, more), folder_.path()};
        expectOne(one.finish());
        expectOne(other.finish());
        EXPECT_EQ(everything(of), everything("unbroken-" + of));
    }
}

// As where a node falls silent: its task is started again, while the old one goes on.
TEST_F(BatchFaults, TasksOfWhichEachRunsTwiceMakeOneSet) {
    expectOne(runWith({}, batch("unbroken")));
    std::vector<std::unique_ptr<Running>> running;
    for (const char* const shard : {"0/2", "1/2"})
        for (int copy = 0; copy < 2; ++copy)
            running.push_back(
                std::make_unique<Running>(INKEDGE_COMMAND, batch("tasks", {"--shard", shard}), folder_.path()));
    int failed = 0;
    for (const auto& each : running) failed += each->finish().exitCode;
    EXPECT_EQ(failed, 2) << "of one task of the two, and both its copies";
    EXPECT_FALSE(std::filesystem::exists(folder_ / "tasks/results.jsonl"));
    expectOne(runWith({}, batch("tasks")));  // puts the results together
    EXPECT_EQ(everything("tasks"), everything("unbroken"));
}

bool hasEnded(const Running& running) {
    siginfo_t info{};
    const int failed = ::waitid(P_PID, static_cast<id_t>(running.process()), &info, WEXITED | WNOHANG | WNOWAIT);
    return failed != 0 || info.si_pid != 0;
}

/// Whether llvmpipe has started threads of its own in one of these processes.
bool driverHasThreads(const std::set<pid_t>& processes) {
    for (const pid_t process : processes) {
        std::error_code ignored;
        const std::string tasks = "/proc/" + std::to_string(process) + "/task";
        for (const auto& task : std::filesystem::directory_iterator{tasks, ignored}) {
            std::string name;
            std::ifstream{task.path() / "comm"} >> name;
            if (name.starts_with("llvmpipe-")) return true;
        }
    }
    return false;
}

TEST_F(BatchFaults, DriversDrawInTheThreadsThatKeepTheCoresBusy) {
    const auto startsThreads = [&](const Arguments& arguments, const Environment& environment) {
        Running running{INKEDGE_COMMAND, arguments, folder_.path(), environment};
        bool found = false;
        while (!hasEnded(running)) {
            std::set<pid_t> processes = childrenOf(running.process());
            processes.insert(running.process());
            found |= driverHasThreads(processes);
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        EXPECT_EQ(running.finish().exitCode, arguments.front() == "batch" ? 1 : 0);
        return found;
    };
    const std::string views = "turntable:" + std::to_string(8 * std::max(1U, std::thread::hardware_concurrency()));
    const Arguments render{"render", asset("bracket.glb"), "-o", "{view}.png", "--size", "64x64", "--views", views};
    if (!startsThreads(render, {{"LP_NUM_THREADS", "2"}})) GTEST_SKIP() << "NOT TRIED: llvmpipe does not draw here";
    EXPECT_FALSE(startsThreads(render, {}));
    EXPECT_FALSE(startsThreads(batch("out"), {}));
}

TEST_F(BatchFaults, AWorkerThatIsKilledCostsNothing) {
    Running running{INKEDGE_COMMAND, batch("out"), folder_.path()};
    std::set<pid_t> killed;
    while (killed.size() < 3) {
        for (const pid_t worker : childrenOf(running.process()))
            if (killed.size() < 3 && killed.insert(worker).second) {
                std::this_thread::sleep_for(std::chrono::milliseconds{200});  // it is at work
                ::kill(worker, SIGKILL);
            }
        if (hasEnded(running)) break;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    EXPECT_FALSE(killed.empty());
    expectOne(running.finish());
    for (const auto& [id, state] : states("out")) EXPECT_EQ(state, id == "damaged.stl" ? "refused" : "drawn") << id;
}

// Takes minutes at a fine tolerance.
constexpr const char* endless =
    "bounds -1 -1 -1 1 1 1\nf = x^2 + y^2 + z^2 - 0.5 + 0.001*sin(400*x)*sin(400*y)*sin(400*z)\n";

TEST_F(BatchFaults, AnItemThatCrashesItsWorkersCostsALine) {
    put(models_of_batch_ / "endless.implicit", endless);
    Running running{INKEDGE_COMMAND, batch("out", {"--tolerance", "0.001"}), folder_.path()};
    const auto drawn = [&] {
        const auto file = folder_ / "out" / "results.jsonl";
        return std::filesystem::exists(file) ? std::ranges::count(contents(file), '\n') : 0;
    };
    const auto all = std::ranges::distance(std::filesystem::directory_iterator{models_of_batch_});
    while (!hasEnded(running) && drawn() < all - 1) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    while (!hasEnded(running)) {
        for (const pid_t worker : childrenOf(running.process())) ::kill(worker, SIGSEGV);
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    expectOne(running.finish());
    for (const json& result : results("out"))
        if (result["id"] == "endless.implicit") {
            EXPECT_EQ(result["state"], "crashed");
            EXPECT_EQ(result["error"], "expected it to be drawn, found a crash (Segmentation fault)");
        } else {
            EXPECT_EQ(result["state"], result["id"] == "damaged.stl" ? "refused" : "drawn") << result;
        }
}

TEST_F(BatchFaults, AnItemThatTakesTooLongCostsALine) {
    put(models_of_batch_ / "endless.implicit", endless);
    expectOne(runWith({}, batch("out", {"--timeout", "20", "--tolerance", "0.001"})));
    const auto all = states("out");
    EXPECT_EQ(all.at("endless.implicit"), "timeout");
    EXPECT_EQ(std::ranges::count_if(all, [](const auto& each) { return each.second == "drawn"; }),
              static_cast<std::ptrdiff_t>(all.size()) - 2);
    for (const json& result : results("out"))
        if (result["state"] == "timeout") {
            EXPECT_EQ(result["limit"], 20.0);
            EXPECT_THAT(result["error"].get<std::string>(),
                        HasSubstr("expected it to be drawn within 20 s, found it still at work; raise --timeout"));
        }
    std::filesystem::remove(models_of_batch_ / "endless.implicit");
    put(models_of_batch_ / "endless.implicit", endless);
    EXPECT_THAT(runWith({}, batch("out", {"--timeout", "20", "--tolerance", "0.001"})).out,
                HasSubstr(" items: 0 drawn"))
        << "it is not tried again for the same time";
}

TEST_F(BatchFaults, AnItemThatTakesTooMuchMemoryCostsALine) {
    std::filesystem::copy_file(bigModel(1500), models_of_batch_ / "big.gltf");
    std::filesystem::copy_file(models_ / "big.bin", models_of_batch_ / "big.bin");
    expectOne(runWith({}, batch("out", {"--max-memory", "400MB"})));
    for (const json& result : results("out")) {
        if (result["id"] == "big.gltf") {
            EXPECT_EQ(result["state"], "memory");
            EXPECT_THAT(result["error"].get<std::string>(),
                        AllOf(HasSubstr("expected at most 400 MB of memory, found "), HasSubstr("raise --max-memory")));
        } else {
            EXPECT_EQ(result["state"], result["id"] == "damaged.stl" ? "refused" : "drawn") << result;
        }
    }
}

TEST_F(BatchFaults, ASignalEndsItAndItsWorkersWhole) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string out = "out" + std::to_string(signal);
        Running running{INKEDGE_COMMAND, batch(out), folder_.path()};
        std::set<pid_t> workers;
        while (!hasEnded(running) && (workers = childrenOf(running.process())).size() < 2)
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        std::this_thread::sleep_for(std::chrono::milliseconds{20});  // they make their contexts
        for (const pid_t worker : workers) ::kill(worker, signal);   // as a terminal and Slurm do
        ::kill(running.process(), signal);
        EXPECT_EQ(running.finish().exitCode, 128 + signal);
        for (int i = 0; i < 200; ++i) {
            std::erase_if(workers, [](pid_t worker) { return ::kill(worker, 0) != 0; });
            if (workers.empty()) break;
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
        }
        EXPECT_TRUE(workers.empty()) << "a worker goes on";
        expectWhole(out);
        expectOne(runWith({}, batch(out)));
    }
    expectOne(runWith({}, batch("unbroken")));
    for (const int signal : {SIGINT, SIGTERM})
        EXPECT_EQ(everything("out" + std::to_string(signal)), everything("unbroken"));
}

TEST_F(BatchFaults, WithoutOpenGlItEndsAtOnce) {
    const Outcome outcome = Running{INKEDGE_COMMAND, batch("out"), folder_.path(), withoutBackends()}.finish();
    expectFailure(outcome, 4, HasSubstr("expected "));
}

TEST_F(BatchFaults, AnOutputThatTakesNoMoreEndsIt) {
    const Outcome outcome = runWith([] { limit(RLIMIT_FSIZE, 400); }, batch("out"));
    EXPECT_EQ(outcome.exitCode, 5);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("cannot be written: expected room for"), HasSubstr("found: ")));
}

}  // namespace
