#include <inkedge/image.h>

#include <array>
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
    for (const auto& [size, channels] : std::vector<std::pair<Size, int>>{{{-1, 2}, 1}, {{2, -1}, 1}, {{2, 2}, 0}})
        EXPECT_THAT(refusal<std::invalid_argument>([size = size, channels = channels] { Image<int>(size, channels); }),
                    HasSubstr("expected an image of 0 or more pixels"))
            << size.width << " x " << size.height << " x " << channels;
}

TEST(Image, refusesWhatLiesOutside) {
    Image<std::uint8_t> image{{2, 3}, 4};
    EXPECT_EQ(refusal<std::out_of_range>([&] { (void)image.at(2, 0); }),
              "expected a value of an image of 2 x 3 pixels of 4 values, found column 2, row 0, channel 0");
    const std::vector<std::array<int, 3>> outside{{-1, 0, 0}, {0, 3, 0}, {0, -1, 0}, {0, 0, 4}, {0, 0, -1}};
    for (const auto& [x, y, channel] : outside)
        EXPECT_THAT(
            refusal<std::out_of_range>([&image, x = x, y = y, channel = channel] { (void)image.at(x, y, channel); }),
            HasSubstr("expected a value of an image"));
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
