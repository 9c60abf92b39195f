#include <inkedge/image.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace inkedge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class Expected, class F>
std::string refusal(F&& call) {
    try {
        call();
    } catch (const Expected& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(Image, countsRowsFromTheTopAndChannelsTogether) {
    Image<int> image{{2, 3}, 2};
    image(1, 2, 1) = 7;
    image.at(0, 1) = 5;
    EXPECT_THAT(image.pixels(), ElementsAre(0, 0, 0, 0, 5, 0, 0, 0, 0, 0, 0, 7));
    EXPECT_EQ(std::as_const(image).at(1, 2, 1), 7);
    EXPECT_EQ(std::as_const(image)(0, 1), 5);
}

TEST(Image, takesValuesThatFillIt) {
    const Image<float> image{{3, 1}, 1, {1, 2, 3}};
    EXPECT_EQ(image.size(), (Size{3, 1}));
    EXPECT_EQ(image(2, 0), 3.0F);
}

TEST(Image, refusesAnotherNumberOfValues) {
    EXPECT_EQ(refusal<std::invalid_argument>([] {
                  Image<float>({3, 1}, 2, std::vector<float>{1, 2, 3});
              }),
              "expected the values of 3 x 1 pixels of 2 values, found 3");
}

TEST(Image, refusesSidesBelowZeroAndNoChannel) {
    const auto refused = [](Size size, int channels) {
        return refusal<std::invalid_argument>([&] { Image<int>(size, channels); });
    };
    EXPECT_THAT(refused({-1, 2}, 1), HasSubstr("expected an image of 0 or more pixels"));
    EXPECT_THAT(refused({2, -1}, 1), HasSubstr("found 2 x -1 pixels of 1 values"));
    EXPECT_THAT(refused({2, 2}, 0), HasSubstr("found 2 x 2 pixels of 0 values"));
}

TEST(Image, refusesWhatLiesOutside) {
    Image<std::uint8_t> image{{2, 3}, 4};
    const auto refused = [&](int x, int y, int channel) {
        return refusal<std::out_of_range>([&] { (void)image.at(x, y, channel); });
    };
    EXPECT_EQ(refused(2, 0, 0),
              "expected a value of an image of 2 x 3 pixels of 4 values, found column 2, row 0, channel 0");
    EXPECT_THAT(refused(-1, 0, 0), HasSubstr("found column -1"));
    EXPECT_THAT(refused(0, 3, 0), HasSubstr("row 3"));
    EXPECT_THAT(refused(0, -1, 0), HasSubstr("row -1"));
    EXPECT_THAT(refused(0, 0, 4), HasSubstr("channel 4"));
    EXPECT_THAT(refused(0, 0, -1), HasSubstr("channel -1"));
}

TEST(Image, isEmptyOnceItWasMovedFrom) {
    Image<int> from{{2, 2}, 3, 1};
    Image<int> to{std::move(from)};
    EXPECT_TRUE(from.empty());
    EXPECT_EQ(from.size(), Size{});
    from = std::move(to);
    EXPECT_EQ(from.pixels().size(), 12U);
    EXPECT_EQ(to.channels(), 1);
    EXPECT_THAT(to.pixels(), IsEmpty());
}

TEST(Image, givesItsValuesAway) {
    Image<int> image{{2, 1}, 1, {1, 2}};
    EXPECT_THAT(std::move(image).pixels(), ElementsAre(1, 2));
    EXPECT_TRUE(image.empty());
    EXPECT_EQ(image.size(), Size{});
}

TEST(Image, changesValuesAndNeverTheirNumber) {
    Image<int> image{{2, 1}, 1};
    for (int& value : image.mutablePixels()) value = 4;
    EXPECT_THAT(image.pixels(), ElementsAre(4, 4));
}

}  // namespace
}  // namespace inkedge
