// Which items one of several tasks draws, and what schedulers say of it.
#include "batch/portion.h"

#include <map>

#include <gmock/gmock.h>

#include "base/expect_error.h"

namespace inkedge::batch {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Variables = std::map<std::string, std::string>;

Portion portion(const std::string& text, const Variables& variables = {}) {
    return portionOf(text, [&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    });
}

std::string said(const std::string& text, const Variables& variables = {}) {
    const Portion of = portion(text, variables);
    return std::to_string(of.index) + "/" + std::to_string(of.count);
}

void expectRefused(const std::string& text, const Variables& variables, const auto& message) {
    expectError(Error::Kind::Usage, message, [&] { static_cast<void>(portion(text, variables)); });
}

Variables slurm(int id, int first, int last, int count, int step = 1) {
    return {{"SLURM_ARRAY_TASK_ID", std::to_string(id)},
            {"SLURM_ARRAY_TASK_MIN", std::to_string(first)},
            {"SLURM_ARRAY_TASK_MAX", std::to_string(last)},
            {"SLURM_ARRAY_TASK_COUNT", std::to_string(count)},
            {"SLURM_ARRAY_TASK_STEP", std::to_string(step)}};
}

TEST(PortionTest, isTheOneThatIsGiven) {
    EXPECT_EQ(said(""), "0/1");
    EXPECT_EQ(said("0/1"), "0/1");
    EXPECT_EQ(said("7/8"), "7/8");
    EXPECT_EQ(said("2/3", slurm(7, 3, 11, 3)), "2/3") << "whatever a scheduler says";
    for (const char* text : {"8/8", "-1/8", "1", "/8", "1/", "a/8", "1/0", "1/2/3", "1 /8", "0/1000001"})
        expectRefused(text, {}, StartsWith("--shard: expected I/N, I from 0 to N - 1, or auto/N, found '"));
}

TEST(PortionTest, holdsEachItemOnce) {
    std::map<std::uint64_t, int> sizes;
    for (int item = 0; item < 8000; ++item) {
        int holders = 0;
        for (std::uint64_t index = 0; index < 8; ++index) {
            if (!holds({index, 8}, "set/" + std::to_string(item))) continue;
            ++holders;
            ++sizes[index];
        }
        EXPECT_EQ(holders, 1);
        EXPECT_TRUE(holds({}, std::to_string(item)));
    }
    for (const auto& [index, size] : sizes) EXPECT_NEAR(size, 1000, 120) << "four standard deviations of chance";
    EXPECT_TRUE(holds({2, 8}, "bracket.glb")) << "the same in all versions, for runs that are gone on with";
}

TEST(PortionTest, isThatOfATaskOfSlurm) {
    EXPECT_EQ(said("", slurm(3, 0, 7, 8)), "3/8");
    EXPECT_EQ(said("", slurm(1, 1, 8, 8)), "0/8");
    EXPECT_EQ(said("", slurm(7, 1, 10, 4, 3)), "2/4") << "--array=1-10:3";
    EXPECT_EQ(said("", slurm(5, 5, 5, 1)), "0/1") << "--array=5";
    EXPECT_EQ(said("auto/8", slurm(3, 0, 7, 8)), "3/8");
    expectRefused("auto/9", slurm(3, 0, 7, 8),
                  testing::StrEq("--shard: expected auto/8, as SLURM_ARRAY_TASK_ID has it, found auto/9"));
}

TEST(PortionTest, isAskedForWhereAListHidesIt) {
    const auto message = AllOf(StartsWith("SLURM_ARRAY_TASK_ID: expected a task of an array in even steps, as "
                                          "--array=0-7, found 7 of 3 from 3 to 11"),
                               HasSubstr("give --shard I/N"));
    expectRefused("", slurm(7, 3, 11, 3), message);
    expectRefused("auto/3", slurm(7, 3, 11, 3), message);
    for (const Variables& wrong : {slurm(8, 1, 10, 4, 3), slurm(0, 1, 8, 8), slurm(9, 1, 8, 8), slurm(1, 1, 8, 8, 0),
                                   slurm(1, 1, 8, 0), slurm(3, 8, 1, 8)})
        expectRefused("", wrong, HasSubstr("give --shard I/N"));
    Variables missing = slurm(3, 0, 7, 8);
    missing.erase("SLURM_ARRAY_TASK_STEP");
    expectRefused("", missing, StartsWith("SLURM_ARRAY_TASK_STEP: expected a whole number, found none"));
    missing["SLURM_ARRAY_TASK_STEP"] = "1x";
    expectRefused("", missing, StartsWith("SLURM_ARRAY_TASK_STEP: expected a whole number, found '1x'"));
}

TEST(PortionTest, isThatOfATaskOfAwsBatch) {
    EXPECT_EQ(said("", {{"AWS_BATCH_JOB_ARRAY_INDEX", "2"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "5"}}), "2/5");
    EXPECT_EQ(said("auto/5", {{"AWS_BATCH_JOB_ARRAY_INDEX", "2"}}), "2/5");
    expectRefused("", {{"AWS_BATCH_JOB_ARRAY_INDEX", "5"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "5"}},
                  StartsWith("AWS_BATCH_JOB_ARRAY_INDEX: expected a number under 5, found 5"));
}

TEST(PortionTest, isThatOfAPodOfKubernetesIfItsNumberIsSaid) {
    EXPECT_EQ(said("auto/8", {{"JOB_COMPLETION_INDEX", "7"}}), "7/8");
    expectRefused("", {{"JOB_COMPLETION_INDEX", "7"}},
                  StartsWith("JOB_COMPLETION_INDEX: expected --shard auto/N beside it"));
    expectRefused("auto/7", {{"JOB_COMPLETION_INDEX", "7"}},
                  StartsWith("JOB_COMPLETION_INDEX: expected a number under 7, found 7"));
    expectRefused("auto/7", {}, StartsWith("--shard: expected auto in a task of Slurm, Kubernetes or AWS Batch"));
}

TEST(PortionTest, namesItsFilesInOneOrder) {
    EXPECT_EQ(nameOf({}), "");
    EXPECT_EQ(nameOf({3, 8}), "3-of-8");
    EXPECT_EQ(nameOf({3, 100}), "003-of-100");
}

}  // namespace
}  // namespace inkedge::batch
