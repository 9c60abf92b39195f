#include "settings/pens.h"

#include <gtest/gtest.h>

namespace inkedge::settings {
namespace {

constexpr std::uint8_t outline = 0;  // by the bits of LineType
constexpr std::uint8_t occlusion = 1;
constexpr std::uint8_t crease = 3;

TEST(Pens, takeTheCommonWidthAndColourUnlessTheirTypeHasItsOwn) {
    PictureSettings settings;
    settings.lineWidth = {2.5, false};
    settings.lineColor = {1, 2, 3};
    settings.pens[crease] = {PictureLength{1.0, false}, Color{9, 9, 9}};
    settings.pens[occlusion].width = PictureLength{4.0, false};
    const auto all = pens(settings);
    EXPECT_EQ(all[outline].width, 2.5);
    EXPECT_EQ(all[outline].color, (Color{1, 2, 3}));
    EXPECT_EQ(all[crease].width, 1.0);
    EXPECT_EQ(all[crease].color, (Color{9, 9, 9}));
    EXPECT_EQ(all[occlusion].width, 4.0);
    EXPECT_EQ(all[occlusion].color, (Color{1, 2, 3}));
}

TEST(Pens, turnMillimetresIntoPixelsByTheResolution) {
    PictureSettings settings;
    settings.lineWidth = {0.5, true};
    settings.dpi = 254.0;  // ten pixels per millimetre
    EXPECT_DOUBLE_EQ(pens(settings)[outline].width, 5.0);
    settings.dpi = 127.0;
    EXPECT_DOUBLE_EQ(pens(settings)[outline].width, 2.5);
    settings.lineWidth = {0.5, false};
    EXPECT_DOUBLE_EQ(pens(settings)[outline].width, 0.5) << "pixels do not depend on it";
}

TEST(Pens, ofLinesOfFormAndOfTangentLinesAreNarrower) {
    PictureSettings picture;
    picture.lineWidth = {2.0};
    const auto widthOf = [&](LineType type) { return pens(picture)[static_cast<std::size_t>(bitIndex(type))].width; };
    for (const LineType type : standardLineTypes - LineType::Tangent) EXPECT_EQ(widthOf(type), 2.0) << name(type);
    EXPECT_EQ(widthOf(LineType::Tangent), 1.0);
    for (const LineType type : formLineTypes) EXPECT_DOUBLE_EQ(widthOf(type), 1.2) << name(type);
    picture.pens[static_cast<std::size_t>(bitIndex(LineType::Ridge))].width = PictureLength{3.0};
    EXPECT_EQ(widthOf(LineType::Ridge), 3.0);
}

}  // namespace
}  // namespace inkedge::settings
