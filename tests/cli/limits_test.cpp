// Too little memory or time: the right exit code, a line that says what to do, and no file left. The table of faults is
// in tests/README.md.
#include <cstdio>

#include <sys/resource.h>

#include "cli/decode_png.h"
#include "cli/faults.h"

namespace {

using namespace faults;
using testing::AllOf;
using testing::AnyOf;
using testing::Eq;
using testing::HasSubstr;

// --- time ---

class Timeout : public Faults {};

TEST_F(Timeout, EndsTheWorkOnABigModel) {
    const std::string model = bigModel(700);
    expectFailure(
        run({"render", model, "-o", "a.png", "--metadata", "a.json", "--maps", everyMap(), "--timeout", "0.1"}), 1,
        HasSubstr(model + ": expected the work to end within 0.1 s, found it still going"));
    expectNothingLeft();
}

TEST_F(Timeout, DoesNotMeetWorkThatEndsBefore) {
    expectSuccess(run({"render", roof(), "-o", "a.png", "--size", "16x16", "--timeout", "100"}));
}

TEST_F(Timeout, WorksWhereTheCallerBlocksTheAlarm) {
    const auto block = [] {
        sigset_t alarm;
        ::sigemptyset(&alarm);
        ::sigaddset(&alarm, SIGALRM);
        ::sigprocmask(SIG_BLOCK, &alarm, nullptr);
    };
    EXPECT_EQ(runWith(block, {"render", bigModel(700), "-o", "a.png", "--timeout", "1e-9"}).exitCode, 1);
    expectNothingLeft();
}

TEST_F(Timeout, RefusesATimeThatIsNone) {
    for (const char* time : {"0", "-1", "nan", "inf", "5s", "1e9"}) {
        expectFailure(run({"render", roof(), "-o", "a.png", std::string{"--timeout="} + time}), 2,
                      HasSubstr(std::string{"--timeout: expected a number over 0"}));
    }
    expectNothingLeft();
}

// --- memory ---

class Memory : public Faults {
protected:
    void SetUp() override {
        if (!addressSpaceCanBeLimited) GTEST_SKIP() << "the address sanitizer needs the address space here";
    }
    static Prepare megabytes(rlim_t count) {
        return [count] {
            limit(RLIMIT_AS, count << 20U);
            limit(RLIMIT_CORE, 0);
        };
    }
};

// The model has 18 MB; its scene needs ten times that.
TEST_F(Memory, TooLittleForTheModel) {
    const std::string model = bigModel(700);
    for (const rlim_t count : std::initializer_list<rlim_t>{40, 60, 80, 100}) {
        const Outcome outcome = runWith(megabytes(count), {"render", model, "-o", "a.png", "--size", "64x64"});
        EXPECT_THAT(outcome.exitCode, AnyOf(Eq(1), Eq(3))) << count << " MB";
        expectFailure(outcome, outcome.exitCode, HasSubstr("memory"));
        expectNothingLeft();
    }
}

// Drivers may crash when they get no memory; the line and the folder are ours even then.
TEST_F(Memory, TooLittleForSomeStage) {
    const std::string model = bigModel(300);
    for (rlim_t count = 100; count < 800; count += 100) {
        const Outcome outcome = runWith(megabytes(count), {"render", model, "-o", "a.png", "--size", "500x500"});
        if (outcome.exitCode == 0) {
            EXPECT_EQ(decodePng(contents(folder_ / "a.png")).width, 500U);
            std::filesystem::remove(folder_ / "a.png");
        } else {
            EXPECT_THAT(outcome.error,
                        AllOf(HasSubstr("inkedge: error: "), HasSubstr("expected "), HasSubstr("found ")))
                << count << " MB";
        }
        expectNothingLeft();
    }
}

TEST_F(Memory, TooLittleForAPicture) {
    for (const char* backend : {"egl", "osmesa"}) {
        const auto about = nlohmann::json::parse(run({"doctor", "--json"}).out);
        const bool software = std::ranges::any_of(about["backends"], [&](const auto& each) {
            return each["backend"] == backend && each["works"] && each["software"];
        });
        if (!software) {
            std::printf("[  SKIPPED ] Memory.TooLittleForAPicture: no %s in software here\n", backend);
            continue;
        }
        expectFailure(runWith(megabytes(1500), {"render", roof(), "-o", "a.png", "--size", "8192x8192", "--tile-size",
                                                "8192", "--backend", backend}),
                      1, HasSubstr("expected graphics memory for a picture of 8192 x 8192 pixels, found too little; "));
        expectNothingLeft();
    }
}

}  // namespace
