#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace inkedge::batch {

/// Hands things from one thread to another, in their order. Whoever puts waits while so many are on their way.
template <class Thing>
class Channel {
public:
    explicit Channel(std::size_t capacity) : capacity_{capacity} {}

    void put(Thing thing) {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [&] { return things_.size() < capacity_; });
        things_.push_back(std::move(thing));
        changed_.notify_all();
    }

    [[nodiscard]] Thing take() {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [&] { return !things_.empty(); });
        Thing thing = std::move(things_.front());
        things_.pop_front();
        changed_.notify_all();
        return thing;
    }

private:
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Thing> things_;
};

}  // namespace inkedge::batch
