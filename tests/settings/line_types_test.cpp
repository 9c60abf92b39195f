#include <inkedge/line_types.h>

#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <inkedge/setting_table.h>

namespace inkedge::settings {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

static_assert(std::forward_iterator<LineTypes::Iterator>);
static_assert((LineType::Outline | LineType::Marked).bits() == 129);
static_assert(allLineTypes.size() == lineTypeCount);

std::vector<LineType> typesIn(LineTypes types) { return {types.begin(), types.end()}; }

TEST(LineTypes, holdThoseThatWerePutIn) {
    const LineTypes types = LineType::Crease | LineType::Outline;
    EXPECT_TRUE(types.contains(LineType::Crease));
    EXPECT_TRUE(types.contains(LineType::Outline));
    EXPECT_FALSE(types.contains(LineType::Marked));
    EXPECT_EQ(types, (LineTypes{LineType::Outline, LineType::Crease}));
    EXPECT_EQ(types.size(), 2);
    EXPECT_TRUE(LineTypes{}.empty());
    EXPECT_FALSE(types.empty());
}

TEST(LineTypes, haveANameEach) {
    for (const LineType type : allLineTypes) EXPECT_THAT(name(type), Not(IsEmpty())) << bitIndex(type);
}

TEST(LineTypes, areToldFromTheLowestBitUp) {
    EXPECT_THAT(typesIn(LineType::Marked | LineType::Outline | LineType::Crease),
                ElementsAre(LineType::Outline, LineType::Crease, LineType::Marked));
    EXPECT_THAT(typesIn({}), IsEmpty());
    EXPECT_EQ((LineType::Marked | LineType::Boundary).first(), LineType::Boundary);
}

TEST(LineTypes, joinMeetAndDiffer) {
    const LineTypes a{LineType::Outline, LineType::Crease};
    const LineTypes b{LineType::Crease, LineType::Marked};
    EXPECT_THAT(typesIn(a | b), ElementsAre(LineType::Outline, LineType::Crease, LineType::Marked));
    EXPECT_THAT(typesIn(a & b), ElementsAre(LineType::Crease));
    EXPECT_THAT(typesIn(a - b), ElementsAre(LineType::Outline));
    EXPECT_EQ(allLineTypes - allLineTypes, LineTypes{});
}

TEST(LineTypes, haveRoomFor32) {
    constexpr auto last = static_cast<LineType>(1U << 31U);
    const LineTypes types = LineTypes::fromBits(~0U);
    EXPECT_EQ(types.size(), 32);
    EXPECT_TRUE(types.contains(last));
    EXPECT_EQ(bitIndex(last), 31);
    EXPECT_EQ(typesIn(types).back(), last);
    EXPECT_FALSE(allLineTypes.contains(last));
}

TEST(LineTypes, goThroughTextUnchanged) {
    for (std::uint32_t bits = 0; bits <= allLineTypes.bits(); ++bits) {
        Settings settings;
        settings.picture.lines = LineTypes::fromBits(bits);
        std::string text;
        for (const SettingDescription& row : settingTable())
            if (row.name == "lines") text = row.get(settings);
        settings.picture.lines = {};
        set(settings, "lines", text, "test");
        EXPECT_EQ(settings.picture.lines.bits(), bits) << text;
    }
}

TEST(LineTypes, haveWordsForSeveral) {
    const auto typesOf = [](std::string_view text) {
        Settings settings;
        settings.picture.lines = {};
        set(settings, "lines", text, "test");
        return settings.picture.lines;
    };
    EXPECT_EQ(typesOf("all"), allLineTypes);
    EXPECT_EQ(typesOf("standard"), Settings{}.picture.lines);
    EXPECT_EQ(typesOf("standard,ridge"), standardLineTypes | LineType::Ridge);
    EXPECT_EQ(standardLineTypes | formLineTypes, allLineTypes);
    EXPECT_TRUE((standardLineTypes & formLineTypes).empty());
    EXPECT_EQ(formLineTypes.size(), 4);
}

TEST(LineTypes, haveNamesAndWhatIsNoneHasNone) {
    EXPECT_EQ(name(LineType::Outline), "outline");
    EXPECT_EQ(name(LineType::Marked), "marked");
    EXPECT_EQ(name(LineType::Apparent), "apparent");
    EXPECT_EQ(name(LineType::Tangent), "tangent");
    EXPECT_EQ(name(LineType{}), "");
    EXPECT_EQ(name(static_cast<LineType>(1U << 31U)), "");
    EXPECT_EQ(name(static_cast<LineType>(3)), "") << "two at once";
}

}  // namespace
}  // namespace inkedge::settings
