// Tars as others read them: Python's tarfile is asked by tests/cli/batch_test.cpp, too.
#include "batch/tar.h"

#include <fcntl.h>
#include <unistd.h>

#include <gmock/gmock.h>

#include "base/temporary_folder.h"

namespace inkedge::batch {
namespace {

std::string text(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

std::string member(const std::string& name, const std::string& content) {
    return text(tarHeader(name, content.size())) + content + text(tarPadding(content.size()));
}

std::vector<TarMember> membersOf(const std::string& tar) {
    const TemporaryFolder folder;
    put(folder / "a.tar", tar);
    const int file = ::open((folder / "a.tar").c_str(), O_RDONLY | O_CLOEXEC);
    std::vector<TarMember> members = tarMembers(file);
    ::close(file);
    return members;
}

TEST(Tar, holdsMembersInWholeBlocks) {
    const std::string longName = std::string(90, 'a') + "/" + std::string(90, 'b') + "/000.outline.png";
    const std::vector<std::string> names{"a/000.json", longName, "a/\u00e4.png", std::string(100, 'n')};
    std::string tar;
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < names.size(); ++i) {
        tar += member(names[i], std::string(511 * i, 'x'));
        EXPECT_EQ(tar.size() % tarBlock, 0U);
        ends.push_back(tar.size());
    }
    const std::vector<TarMember> members = membersOf(tar + text(tarEnd()));
    ASSERT_EQ(members.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(members[i].name, names[i]);
        EXPECT_EQ(members[i].begin, i == 0 ? 0 : ends[i - 1]);
        EXPECT_EQ(members[i].end, ends[i]);
    }
    EXPECT_EQ(member("a", "b"), member("a", "b")) << "nothing in it changes from run to run";
}

TEST(Tar, takesMembersOfOverEightGigabytes) {
    constexpr std::uint64_t large = std::uint64_t{9} << 30U;
    const TemporaryFolder folder;
    put(folder / "a.tar", text(tarHeader("large", large)));
    const std::uint64_t begin = std::filesystem::file_size(folder / "a.tar");
    std::filesystem::resize_file(folder / "a.tar", begin + large + 2 * tarBlock);  // a file with a hole
    const int file = ::open((folder / "a.tar").c_str(), O_RDONLY | O_CLOEXEC);
    const std::vector<TarMember> members = tarMembers(file);
    ::close(file);
    ASSERT_EQ(members.size(), 1U);
    EXPECT_EQ(members[0].end, begin + large);
}

TEST(Tar, ofOthersHasNoMembers) {
    const std::string tar = member("a", "content");
    EXPECT_EQ(membersOf(tar + text(tarEnd())).size(), 1U);
    EXPECT_EQ(membersOf("no tar").size(), 0U);
    EXPECT_EQ(membersOf(tar).size(), 0U) << "without an end";
    std::string changed = tar + text(tarEnd());
    changed[0] = 'b';  // the checksum does not hold
    EXPECT_EQ(membersOf(changed).size(), 0U);
}

}  // namespace
}  // namespace inkedge::batch
