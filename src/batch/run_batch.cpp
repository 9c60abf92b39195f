#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/job.h>
#include <inkedge/version.h>
#include <inkedge/write_file.h>

#include "base/content_hash.h"
#include "base/message.h"
#include "base/parallel.h"
#include "base/stage_clock.h"
#include "base/staged_files.h"
#include "batch/batch.h"
#include "batch/earlier.h"
#include "batch/hash_set.h"
#include "batch/items.h"
#include "batch/pace.h"
#include "batch/plan.h"
#include "batch/result.h"
#include "batch/results.h"
#include "batch/shards.h"
#include "batch/worker_process.h"
#include "process/memory.h"

namespace inkedge::batch {

std::uint64_t Counts::done() const noexcept {
    return std::accumulate(now.begin(), now.end(), badLines) +
           std::accumulate(before.begin(), before.end(), std::uint64_t{0});
}

std::uint64_t Counts::failures() const noexcept { return done() - now.front() - before.front(); }

std::uint64_t Counts::newFailures() const noexcept { return std::accumulate(now.begin() + 1, now.end(), badLines); }

namespace {

namespace fs = std::filesystem;

// The batch with what is left open filled in, and a folder for it.
Batch prepared(Batch batch) {
    if (batch.jobs == 0) batch.jobs = static_cast<int>(base::usableCores());
    if (batch.maxMemory == 0) batch.maxMemory = process::memoryLimit() / static_cast<unsigned>(batch.jobs);
    std::error_code failure;
    if (fs::equivalent(batch.input, batch.output, failure))
        throw Error{Error::Kind::Usage,
                    fmt::format("--output: expected a folder other than that of the models, found {}; choose another",
                                batch.output.string())};
    return batch;
}

const fs::path& made(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        base::failToWrite(folder, fmt::format("expected a folder or room for one, found: {}", failure.message()));
    return folder;
}

void writeAbout(const Batch& batch, const Planner& planner) {
    const io::Json about{{"version", version()},
                         {"views", batch.views},
                         {"formats", batch.formats},
                         {"shards", planner.shards()},
                         {"settings", differencesOf(batch.settings)}};
    const std::string text = io::textOf(about, 2) + '\n';
    writeFile(batch.output / "batch.json", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// What fails for every item fails before the first.
void check(const Plan& plan, const fs::path& output) {
    Job job = plan.job;
    job.model = "model";
    for (std::string& file : job.outputs) file = (output / file).string();
    checkJobs({&job, 1});
}

// Shards of other portions hold items of this one: those would be there twice.
void expectSamePortions(const Batch& batch) {
    const auto countIn = [](const std::string& portion) {
        return portion.substr(std::min(portion.find('-'), portion.size()));
    };
    const std::string own = nameOf(batch.portion);
    for (const ShardName& shard : shardsIn(batch.output))
        if (countIn(shard.portion) != countIn(own))
            throw Error{Error::Kind::Usage,
                        fmt::format("--shard: expected the number of tasks that wrote the shards in {}, found {} "
                                    "beside those of {}; choose another --output",
                                    batch.output.string(), own.empty() ? "one task" : own,
                                    shard.portion.empty() ? "one task" : shard.portion)};
}

// All that threads have in common which serve one worker process each.
class Run {
public:
    Run(const Batch& batch, const Watch& watch)
        : batch_{prepared(batch)},
          watch_{watch},
          planner_{batch_},
          text_{planner_.text()},
          items_{batch_.input, batch_.output, batch_.portion},
          results_{resultsFile(made(batch_.output), batch_.portion)},
          earlier_{batch_} {
        check(planner_.common(), batch_.output);
        writeAbout(batch_, planner_);
        readResults(batch_.output, [&](std::string_view line) { earlier_.take(line); });
        if (batch_.shards) {
            expectSamePortions(batch_);
            shards_.emplace(batch_.output, *batch_.shards, batch_.portion);
        }
    }

    Progress run() {
        {
            const std::jthread counting{[this] { count(); }};
            std::vector<std::jthread> serving;
            for (int i = 0; i < batch_.jobs; ++i) serving.emplace_back([this] { serveOrFail(); });
            watchOver();
        }
        if (failure_) std::rethrow_exception(failure_);
        if (shards_ && !enough_) shards_->finish();
        results_.compact(otherResults());
        return progress();
    }

private:
    // A run of all items gathers what was written of portions.
    std::vector<fs::path> otherResults() const {
        if (batch_.portion.count > 1) return {};
        std::vector<fs::path> files = resultsFiles(batch_.output);
        std::erase(files, resultsFile(batch_.output, {}));
        return files;
    }

    // ---- the thread that began

    void watchOver() {
        constexpr std::chrono::milliseconds betweenLooks{200};
        try {
            std::unique_lock lock{mutex_};
            while (ended_ < batch_.jobs) {
                changed_.wait_for(lock, betweenLooks);
                lock.unlock();
                if (shards_) shards_->write();
                if (watch_.progress) watch_.progress(progress());
                lock.lock();
            }
        } catch (...) {
            fail();
        }
    }

    Progress progress() {
        const std::scoped_lock lock{mutex_};
        Progress now{counts_, counted_, watchStarted_.milliseconds() / 1000.0, 0.0, {}};
        pace_.add(now.seconds, now.counts.done());
        now.rate = pace_.rate();
        if (now.items) now.left = pace_.left(*now.items - std::min(*now.items, now.counts.done()));
        return now;
    }

    // Beside the work, so that it can be said how much is left.
    void count() {
        if (batch_.input == "-") return;
        std::uint64_t count = 0;
        try {
            Items items{batch_.input, batch_.output, batch_.portion};
            while (!stop_ && !over_) {
                ++count;
                try {
                    if (!items.next()) break;
                } catch (const Error&) {  // counts, too
                }
            }
        } catch (const std::exception&) {
            return;
        }
        const std::scoped_lock lock{mutex_};
        if (!stop_ && !over_) counted_ = count - 1;
    }

    // ---- a thread for each worker

    void serveOrFail() noexcept {
        try {
            serve();
        } catch (...) {
            fail();
        }
        over_ = true;  // of the items
        const std::scoped_lock lock{mutex_};
        ++ended_;
        changed_.notify_all();
    }

    void fail() {
        const std::scoped_lock lock{mutex_};
        if (!failure_) failure_ = std::current_exception();
        stop_ = true;
    }

    void serve() {
        constexpr std::size_t ahead = 2;  // one is drawn while the next is read
        std::unique_ptr<WorkerProcess> worker;
        std::deque<Item> underWay;
        while (true) {
            try {
                while (underWay.size() < ahead) {
                    std::optional<Item> item = next();
                    if (!item) break;
                    underWay.push_back(std::move(*item));
                    if (!worker) worker = start();
                    worker->send(underWay.back());
                }
                if (underWay.empty()) return;
                finish(underWay.front(), worker->receive());
                underWay.pop_front();
            } catch (const NoAnswer& none) {
                const bool only = underWay.size() == 1 && worker->isNew() && none.state() != State::Killed;
                const bool sure = only || none.state() == State::Timeout;
                worker.reset();
                if (sure) {
                    finish(underWay.front(), none);
                    underWay.pop_front();
                }
                for (; !underWay.empty(); underWay.pop_front()) alone(underWay.front(), worker);
            }
        }
    }

    // Which of several items has ended a worker is not known: each is drawn by a new one of its own. One that was ended
    // by others is no fault of the item.
    void alone(const Item& item, std::unique_ptr<WorkerProcess>& worker) {
        constexpr int tries = 3;
        for (int i = 1;; ++i) {
            try {
                worker = start();
                worker->send(item);
                return finish(item, worker->receive());
            } catch (const NoAnswer& none) {
                worker.reset();
                if (none.state() != State::Killed || i == tries) return finish(item, none);
            }
        }
    }

    std::unique_ptr<WorkerProcess> start() {
        return std::make_unique<WorkerProcess>(batch_.program, text_,
                                               WorkerLimits{batch_.timeout, batch_.maxMemory, stop_});
    }

    std::optional<Item> next() {
        while (true) {
            std::optional<Item> item;
            {
                const std::scoped_lock lock{taking_};
                if (stop_ || enough_) return {};
                try {
                    item = items_.next();
                    if (!item) return {};
                    if (!ids_.insert(base::hashOf(item->id)))
                        base::refuse(fmt::format("id: expected one of its own, found {} again", base::quote(item->id)));
                } catch (const Error& error) {
                    leaveOut(error.what(), item);
                    continue;
                }
            }
            if (!wasDone(*item)) return item;
        }
    }

    // A line that is no item, or one whose id another has.
    void leaveOut(const std::string& message, const std::optional<Item>& item) {
        if (item && shards_) shards_->leaveOut(item->number);
        const std::scoped_lock lock{mutex_};
        ++counts_.badLines;
        say(item ? fmt::format("{}: {}", item->model.string(), message) : message);
    }

    bool wasDone(const Item& item) {
        if (earlier_.empty()) return false;
        Plan plan;
        try {
            plan = planner_.planOf(item);
        } catch (const Error&) {
            return false;  // a worker says why
        }
        const std::string key = keyOf(plan, item.model);
        const std::optional<State> state = earlier_.find(item.id, key);
        if (!state || (*state == State::Drawn && !isThere(item, plan, key))) return false;
        if (*state != State::Drawn && shards_) shards_->leaveOut(item.number);
        const std::scoped_lock lock{mutex_};
        ++counts_.before[static_cast<std::size_t>(*state)];
        return true;
    }

    bool isThere(const Item& item, const Plan& plan, const std::string& key) {
        if (shards_) return shards_->takeEarlier(item.number, item.id, partOf(item.id, key));
        return std::ranges::all_of(filesOf(plan), [&](const fs::path& file) {
            std::error_code ignored;
            return fs::exists(batch_.output / item.id / file, ignored);
        });
    }

    // ---- what became of an item

    void finish(const Item& item, const Answer& answer) {
        if (answer.reply == Reply::NoContext) throw Error{Error::Kind::Context, answer.text};
        finish(item, answer.state, answer.text);
    }

    void finish(const Item& item, const NoAnswer& none) {
        Result result{.id = item.id, .state = none.state(), .model = item.model.string(), .error = none.what()};
        result.key = keyOf(planner_.planOf(item), item.model);
        if (none.state() == State::Timeout) result.limit = batch_.timeout;
        if (none.state() == State::Memory) result.limit = static_cast<double>(batch_.maxMemory);
        finish(item, none.state(), lineOf(result));
    }

    // @param line  of the results
    void finish(const Item& item, State state, const std::string& line) {
        results_.append(line);
        const EarlierResult earlier = earlierResult(line).value();
        if (shards_ && state == State::Drawn)
            shards_->take(item.number, item.id, partOf(item.id, earlier.key));
        else if (shards_)
            shards_->leaveOut(item.number);
        const std::scoped_lock lock{mutex_};
        ++counts_.now[static_cast<std::size_t>(state)];
        if (state != State::Drawn) say(fmt::format("{}: {}", item.id, earlier.error));
    }

    // With mutex_ held.
    void say(const std::string& message) {
        if (watch_.failed) watch_.failed(message);
        if (batch_.maxFailures && counts_.newFailures() > *batch_.maxFailures) enough_ = true;
    }

    const Batch batch_;
    const Watch& watch_;
    const Planner planner_;
    const std::string text_;  // of the planner

    std::mutex taking_;  // an item
    Items items_;
    HashSet ids_;

    Results results_;
    Earlier earlier_;
    std::optional<Shards> shards_;

    std::atomic<bool> stop_ = false;    // at once
    std::atomic<bool> enough_ = false;  // items: those under way are finished
    std::atomic<bool> over_ = false;    // no more items

    std::mutex mutex_;  // of what follows
    std::condition_variable changed_;
    int ended_ = 0;  // threads
    Counts counts_;
    std::optional<std::uint64_t> counted_;
    Pace pace_;
    base::Stopwatch watchStarted_;
    std::exception_ptr failure_;
};

}  // namespace

Progress runBatch(const Batch& batch, const Watch& watch) { return Run{batch, watch}.run(); }

}  // namespace inkedge::batch
