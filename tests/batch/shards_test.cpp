// Shards: items in their order, whole, and not written again for nothing.
#include "batch/shards.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "batch/tar.h"

namespace inkedge::batch {
namespace {

using testing::ElementsAre;

std::string text(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

class ShardsTest : public testing::Test {
protected:
    static std::string part(const std::string& id) { return ".part-" + id + ".tar"; }

    // An item's part: 1024 bytes a file.
    void putPart(const std::string& id, int files = 1) const {
        std::string bytes;
        for (int i = 0; i < files; ++i) {
            const std::string content(100, 'x');
            bytes += text(tarHeader(fmt::format("{}/{:03}.png", id, i), content.size())) + content +
                     text(tarPadding(content.size()));
        }
        put(folder_ / part(id), bytes);
    }
    void draw(Shards& shards, std::uint64_t number, const std::string& id) const {
        putPart(id);
        shards.take(number, id, part(id));
    }
    std::vector<std::string> membersOf(const std::string& shard) const {
        const int file = ::open((folder_ / shard).c_str(), O_RDONLY | O_CLOEXEC);
        std::vector<std::string> names;
        for (const TarMember& member : tarMembers(file)) names.push_back(member.name);
        ::close(file);
        return names;
    }
    ino_t inode(const std::string& name) const {
        struct stat about {};
        ::stat((folder_ / name).c_str(), &about);
        return about.st_ino;
    }

    TemporaryFolder folder_;
};

TEST_F(ShardsTest, haveItemsInTheirOrderHoweverTheyCome) {
    Shards shards{folder_.path(), {.items = 2}};
    draw(shards, 1, "b");
    shards.write();
    draw(shards, 2, "c");
    draw(shards, 0, "a");
    shards.write();
    EXPECT_THAT(folder_.names(), ElementsAre(".part-c.tar", "000000.tar")) << "the parts are in it";
    shards.leaveOut(4);
    draw(shards, 3, "d");
    draw(shards, 5, "f");
    draw(shards, 6, "g");
    shards.finish();
    EXPECT_THAT(folder_.names(), ElementsAre("000000.tar", "000001.tar", "000002.tar", "000003.tar"));
    EXPECT_THAT(membersOf("000000.tar"), ElementsAre("a/000.png", "b/000.png"));
    EXPECT_THAT(membersOf("000001.tar"), ElementsAre("c/000.png", "d/000.png"));
    EXPECT_THAT(membersOf("000002.tar"), ElementsAre("f/000.png")) << "what failed leaves its room";
    EXPECT_THAT(membersOf("000003.tar"), ElementsAre("g/000.png"));
}

TEST_F(ShardsTest, haveASize) {
    Shards shards{folder_.path(), {.bytes = 3000}};
    for (const int i : {0, 1, 2, 3}) draw(shards, static_cast<std::uint64_t>(i), fmt::format("{}", i));
    putPart("large", 4);
    shards.take(4, "large", part("large"));
    draw(shards, 5, "last");
    shards.finish();
    EXPECT_THAT(membersOf("000000.tar"), ElementsAre("0/000.png", "1/000.png"));
    EXPECT_THAT(membersOf("000001.tar"), ElementsAre("2/000.png", "3/000.png"));
    EXPECT_EQ(membersOf("000002.tar").size(), 4U) << "one that is larger has its own";
    EXPECT_THAT(membersOf("000003.tar"), ElementsAre("last/000.png"));
}

TEST_F(ShardsTest, areLeftAloneWhereNothingIsNew) {
    const auto run = [&](bool again) {
        Shards shards{folder_.path(), {.items = 2}};
        for (const int i : {0, 1, 2, 3, 4}) {
            const std::string id = fmt::format("{}", i);
            const auto number = static_cast<std::uint64_t>(i);
            if (again) {
                EXPECT_TRUE(shards.takeEarlier(number, id, part(id)));
            } else {
                draw(shards, number, id);
            }
            shards.write();
        }
        shards.finish();
    };
    run(false);
    const std::vector<std::string> names = folder_.names();
    const std::array before{inode("000000.tar"), inode("000001.tar"), inode("000002.tar")};
    run(true);
    EXPECT_EQ(folder_.names(), names);
    EXPECT_EQ((std::array{inode("000000.tar"), inode("000001.tar"), inode("000002.tar")}), before);
}

// An item that failed is drawn at last; what comes after it moves on.
TEST_F(ShardsTest, takeOverWhatOthersHave) {
    {
        Shards shards{folder_.path(), {.bytes = 2100}};
        for (const int i : {0, 1, 2, 3, 4, 5})
            i == 1 ? shards.leaveOut(1) : draw(shards, static_cast<std::uint64_t>(i), fmt::format("{}", i));
        shards.finish();
        EXPECT_THAT(membersOf("000000.tar"), ElementsAre("0/000.png", "2/000.png"));
        EXPECT_THAT(membersOf("000002.tar"), ElementsAre("5/000.png"));
    }
    Shards shards{folder_.path(), {.bytes = 2100}};
    for (const int i : {0, 2, 3, 4, 5}) {
        const std::string id = fmt::format("{}", i);
        EXPECT_TRUE(shards.takeEarlier(static_cast<std::uint64_t>(i), id, part(id))) << id;
    }
    EXPECT_FALSE(shards.takeEarlier(1, "1", part("1")));
    draw(shards, 1, "1");
    shards.finish();
    EXPECT_THAT(membersOf("000000.tar"), ElementsAre("0/000.png", "1/000.png"));
    EXPECT_THAT(membersOf("000001.tar"), ElementsAre("2/000.png", "3/000.png"));
    EXPECT_THAT(membersOf("000002.tar"), ElementsAre("4/000.png", "5/000.png"));
}

TEST_F(ShardsTest, ofAnotherRunBeyondTheLastGo) {
    {
        Shards shards{folder_.path(), {.items = 1}};
        for (const int i : {0, 1, 2}) draw(shards, static_cast<std::uint64_t>(i), fmt::format("{}", i));
        shards.finish();
    }
    Shards shards{folder_.path(), {.items = 2}};
    for (const int i : {0, 1, 2}) {
        const std::string id = fmt::format("{}", i);
        ASSERT_TRUE(shards.takeEarlier(static_cast<std::uint64_t>(i), id, part(id)));
    }
    shards.finish();
    EXPECT_THAT(folder_.names(), ElementsAre("000000.tar", "000001.tar"));
    EXPECT_THAT(membersOf("000000.tar"), ElementsAre("0/000.png", "1/000.png"));
    EXPECT_THAT(membersOf("000001.tar"), ElementsAre("2/000.png"));
}

TEST_F(ShardsTest, knowWhatIsNotThereAnyMore) {
    {
        Shards shards{folder_.path(), {.items = 1}};
        for (const int i : {0, 1, 2, 3}) draw(shards, static_cast<std::uint64_t>(i), fmt::format("{}", i));
        shards.finish();
    }
    std::filesystem::remove(folder_ / "000001.tar");
    Shards shards{folder_.path(), {.items = 1}};
    EXPECT_TRUE(shards.takeEarlier(0, "0", part("0")));
    EXPECT_FALSE(shards.takeEarlier(1, "1", part("1")));
    EXPECT_TRUE(shards.takeEarlier(2, "2", part("2")));
    EXPECT_TRUE(shards.takeEarlier(3, "3", part("3")));
}

// Two copies of a task: the other one has written the shard and removed the parts.
TEST_F(ShardsTest, takeFromAnotherCopyWhatItPutTogether) {
    Shards one{folder_.path(), {.items = 2}};
    Shards other{folder_.path(), {.items = 2}};
    for (Shards* shards : {&one, &other}) {
        draw(*shards, 0, "a");
        draw(*shards, 1, "b");
    }
    one.finish();
    other.finish();
    EXPECT_THAT(folder_.names(), ElementsAre("000000.tar"));
    EXPECT_THAT(membersOf("000000.tar"), ElementsAre("a/000.png", "b/000.png"));
    draw(other, 2, "c");
    std::filesystem::remove(folder_ / part("c"));
    expectError(Error::Kind::Runtime, testing::HasSubstr("expected the files of c, found none; start the batch again"),
                [&] { other.finish(); });
}

}  // namespace
}  // namespace inkedge::batch
