// Too little memory or time: the right exit code, a line that says what to do, and no file left. The table of faults is
// in tests/README.md.
#include <cstddef>
#include <cstdio>

#include <grp.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>

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

// --- threads and processes

class Threads : public Faults {
protected:
    // As if no process or thread could be had, for whoever runs the tests.
    static void refuseThreads() {
        constexpr std::uint32_t fail = SECCOMP_RET_ERRNO;
        sock_filter filter[]{
            BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone3, 0, 1),
            BPF_STMT(BPF_RET | BPF_K, fail | ENOSYS),  // the C library then takes clone
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 0, 1),
            BPF_STMT(BPF_RET | BPF_K, fail | EAGAIN),
            BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        };
        const sock_fprog program{std::size(filter), filter};
        ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) ::_exit(cannotRefuse);
    }
    static constexpr int cannotRefuse = 77;
};

TEST_F(Threads, WithoutThemARenderEndsWithALine) {
    const std::string model = roof();
    for (const std::string output : {"a.png", "a.exr", "a.tif"}) {
        for (const std::string lines : {"image", "object"}) {
            const Outcome outcome =
                runWith(refuseThreads, {"render", model, "-o", output, "--size", "16x16", "--lines-from", lines});
            if (outcome.exitCode == cannotRefuse) GTEST_SKIP() << "no filter of system calls here";
            if (outcome.exitCode == 0) {  // what needs none
                std::filesystem::remove(folder_ / output);
                continue;
            }
            expectFailure(outcome, outcome.exitCode,
                          HasSubstr(outcome.error.find("Embree") == std::string::npos
                                        ? "can be started; raise the limit (ulimit -u)"
                                        : "Embree"));
            EXPECT_LE(outcome.exitCode, 5);
            expectNothingLeft();
        }
    }
    expectFailure(runWith(refuseThreads, {"doctor"}), 1, HasSubstr("expected a process for a trial, found none"));
}

// From none to enough, as a user who may have few: whatever is missing ends in a line.
TEST_F(Threads, WithFewOfThemARenderEndsWithALine) {
    if (!addressSpaceCanBeLimited || ::geteuid() != 0) GTEST_SKIP() << "only root may become another user";
    const std::string model = roof();
    for (const TemporaryFolder* folder : {&folder_, &models_})
        std::filesystem::permissions(folder->path(), std::filesystem::perms{0777});
    for (rlim_t count = 1; count < 20; ++count) {
        const auto few = [count] {
            constexpr uid_t nobody = 54321;  // has no other process
            if (::setgroups(0, nullptr) != 0 || ::setresuid(nobody, nobody, nobody) != 0) ::_exit(127);
            limit(RLIMIT_NPROC, count);
            limit(RLIMIT_CORE, 0);
        };
        for (const std::string output : {"a.png", "a.exr", "a.svg"}) {
            // A driver has no cache here and takes seconds, once it has threads.
            const std::string lines = output == "a.png" && count <= 2 ? "image" : "object";
            const Outcome outcome =
                runWith(few, {"render", model, "-o", output, "--size", "16x16", "--lines-from", lines});
            if (outcome.exitCode == 127) GTEST_SKIP() << "the command cannot be run by another user here";
            if (outcome.exitCode != 0) expectFailure(outcome, outcome.exitCode, HasSubstr("expected "));
            EXPECT_LE(outcome.exitCode, 5) << count << ' ' << outcome.error;
            std::filesystem::remove(folder_ / output);
            expectNothingLeft();
        }
    }
}

// --- files over the limits

class LargeFiles : public Faults {
protected:
    // A file of this size of which the start alone takes room on the disk.
    std::string sparse(const std::string& name, const std::string& start, std::uint64_t size) const {
        const std::string path = file(name, start);
        std::filesystem::resize_file(path, size);
        return path;
    }
    void expectRefusedAtOnce(const std::string& model, const std::string& text) const {
        const Outcome outcome = run({"inspect", model});
        expectFailure(outcome, 3, HasSubstr(text));
        EXPECT_LE(outcome.seconds, 1.0) << model;
        if (addressSpaceCanBeLimited) {
            EXPECT_LE(outcome.peakBytes, std::uint64_t{1} << 27U) << model;
        }
    }
};

TEST_F(LargeFiles, AreRefusedByTheirStartOrSize) {
    constexpr std::uint32_t triangles = 42'000'000;
    std::string header(84, ' ');
    std::memcpy(&header[80], &triangles, sizeof triangles);
    const std::string limit = "expected at most 134217728 vertices and corners, found more; raise max-vertices";
    expectRefusedAtOnce(sparse("a.stl", header, 84 + 50ULL * triangles), limit);
    expectRefusedAtOnce(sparse("cut.stl", header, 2'000'000'000), "the file is truncated");
    expectRefusedAtOnce(sparse("more.stl", header, 3'000'000'000), "raise max-file-size");
    const auto ply = [](const std::string& format, std::uint64_t vertices, std::uint64_t faces) {
        return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
               "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
               "\nproperty list uchar int vertex_indices\nend_header\n";
    };
    expectRefusedAtOnce(sparse("a.ply", ply("binary_little_endian", 170'000'000, 0), 2'100'000'000), limit);
    expectRefusedAtOnce(sparse("b.ply", ply("ascii", 10'000'000, 100'000'000), 2'100'000'000), limit);
    for (const char* name : {"a.obj", "a.glb", "a.gltf"})
        expectRefusedAtOnce(sparse(name, "", 2'200'000'000), "raise max-file-size");
}

// Lists of one byte a corner take four times the memory of the file.
TEST_F(LargeFiles, AreReadUpToTheLimit) {
    const std::string start =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uint uchar vertex_indices\nend_header\n" +
        std::string(36, '\0') + std::string("\0\0\0\x20", 4);  // a face of 2^29 corners
    const Outcome outcome = run({"inspect", sparse("a.ply", start, 64'000'000), "--max-vertices", "1M"});
    expectFailure(outcome, 3, HasSubstr("expected at most 1000000 vertices and corners"));
    if (addressSpaceCanBeLimited) {
        EXPECT_LE(outcome.peakBytes, 100'000'000U);
    }
}

TEST_F(LargeFiles, ThatHaveNoEndAreNotCompared) {
    for (const std::string device : {"/dev/zero", "/dev/stdin"}) {
        expectFailure(run({"compare", device, device}), 3,
                      HasSubstr(device + ": cannot be read as a picture: expected a regular file, found a device"));
    }
    ASSERT_EQ(::mkfifo((models_ / "pipe.png").c_str(), 0600), 0);
    expectFailure(run({"compare", models_ / "pipe.png", models_ / "pipe.png"}), 3,
                  HasSubstr("expected a regular file"));
}

}  // namespace
