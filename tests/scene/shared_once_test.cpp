// What is made once for all who hold it at the same time.
#include "scene/shared_once.h"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <inkedge/error.h>

#include "base/stop.h"

namespace inkedge::scene {
namespace {

TEST(SharedOnce, isMadeOnceHoweverManyWantIt) {
    SharedOnce shared;
    std::atomic<int> made = 0;
    std::vector<std::shared_ptr<const void>> held(8);
    {
        std::vector<std::jthread> threads;
        for (auto& mine : held) {
            threads.emplace_back([&] {
                mine = shared.get([&] {
                    ++made;
                    std::this_thread::sleep_for(std::chrono::milliseconds{20});
                    return std::make_shared<const int>(7);
                });
            });
        }
    }
    EXPECT_EQ(made, 1);
    EXPECT_EQ(shared.holders(), 8);
    for (const auto& mine : held) EXPECT_EQ(*std::static_pointer_cast<const int>(mine), 7);
}

TEST(SharedOnce, isGivenUpWithItsLastHolder) {
    SharedOnce shared;
    int made = 0;
    const auto make = [&] { return std::make_shared<const int>(++made); };
    auto first = shared.get(make);
    auto second = shared.get(make);
    first.reset();
    EXPECT_EQ(shared.holders(), 1);
    second.reset();
    EXPECT_EQ(shared.holders(), 0);
    EXPECT_EQ(*std::static_pointer_cast<const int>(shared.get(make)), 2);
}

TEST(SharedOnce, isTriedAgainAfterAFailure) {
    SharedOnce shared;
    EXPECT_THROW((void)shared.get([]() -> std::shared_ptr<const void> { throw std::runtime_error{"no"}; }),
                 std::runtime_error);
    EXPECT_NE(shared.get([] { return std::make_shared<const int>(1); }), nullptr);
}

TEST(SharedOnce, isNotWaitedForByWhoIsAskedToStop) {
    SharedOnce shared;
    std::atomic<bool> making = false;
    std::atomic<bool> gaveUp = false;
    const std::jthread maker{[&] {
        (void)shared.get([&] {
            making = true;
            while (!gaveUp) std::this_thread::yield();
            return std::make_shared<const int>(1);
        });
    }};
    while (!making) std::this_thread::yield();
    const base::StopScope scope{[] { return true; }};
    EXPECT_THROW((void)shared.get([] { return std::make_shared<const int>(2); }), Error);
    gaveUp = true;
}

}  // namespace
}  // namespace inkedge::scene
