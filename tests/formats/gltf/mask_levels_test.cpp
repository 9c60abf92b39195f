// Masks that are too fine to be cut along in time are halved, and no others.
#include "formats/gltf/mask_levels.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "mesh/mask_detail.h"

namespace inkedge::gltf {
namespace {

template <class Value>
Mask maskOf(Size size, Value&& value) {
    inkedge::Image<std::uint8_t> mask{size, 1};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) mask(x, y) = static_cast<std::uint8_t>(value(x, y));
    return std::make_shared<const inkedge::Image<std::uint8_t>>(std::move(mask));
}

Mask noise(int side) {
    std::mt19937 random{2};
    return maskOf({side, side}, [&](int, int) { return random() % 2 == 0 ? 255 : 0; });
}

Mask disc(int side) {
    return maskOf({side, side},
                  [&](int x, int y) { return std::hypot(x - side / 2, y - side / 2) < 0.4 * side ? 255 : 0; });
}

double meanOf(const inkedge::Image<std::uint8_t>& mask) {
    double sum = 0.0;
    for (const std::uint8_t value : mask.pixels()) sum += value;
    return sum / static_cast<double>(mask.pixels().size());
}

constexpr double threshold = 127.5;
MaskUse whole(std::uint64_t image) { return {image, threshold, 1.0, 6.0, 2.0, false}; }

TEST(MaskDetail, HalvedTexelsAreMeansOfWhatTheyCover) {
    const Mask even = maskOf({4, 2}, [](int x, int y) { return 10 * (2 * x + y); });
    const inkedge::Image<std::uint8_t> half = mesh::halved(*even);
    EXPECT_EQ(half.size(), (Size{2, 1}));
    EXPECT_EQ(half(0, 0), 15);  // of 0, 10, 20 and 30
    EXPECT_EQ(half(1, 0), 55);
    const Mask odd = maskOf({5, 1}, [](int x, int) { return 50 * x; });
    EXPECT_EQ(mesh::halved(*odd)(0, 0), 40);  // (0 + 50 + 100 / 2) / 2.5
    EXPECT_EQ(mesh::halved(*odd)(1, 0), 160);
    EXPECT_EQ(mesh::halved(*maskOf({1, 1}, [](int, int) { return 7; })).size(), (Size{1, 1}));
    EXPECT_NEAR(meanOf(mesh::halved(*noise(375))), meanOf(*noise(375)), 0.5);  // rounded to whole levels
}

TEST(MaskDetail, NoiseHasACornerAboutEachTexelAndADiscFew) {
    const Mask fine = noise(256);
    const double corners = mesh::outlineCorners(*fine, mesh::halved(*fine), threshold);
    EXPECT_GT(corners, 0.3 * 256 * 256);
    EXPECT_LT(corners, 1.5 * 256 * 256);
    const Mask smooth = disc(1024);
    EXPECT_LT(mesh::outlineCorners(*smooth, mesh::halved(*smooth), threshold), 0.5 * M_PI * 0.8 * 1024);
}

TEST(MaskLevels, OnlyWhatIsTooFineIsHalved) {
    const auto coarser = coarserMasks({whole(0), whole(1), whole(2)}, {{0, noise(900)}, {1, disc(1024)}, {2, nullptr}});
    ASSERT_EQ(coarser.size(), 1U);
    EXPECT_EQ(coarser.at(0)->size(), (Size{450, 450}));
    EXPECT_TRUE(coarserMasks({whole(0)}, {{0, noise(256)}}).empty());
}

TEST(MaskLevels, WhatRepeatsAMaskOftenMakesItTooFine) {
    MaskUse often = whole(0);
    often.area = 400.0;
    often.edges = 120.0;
    const auto coarser = coarserMasks({often}, {{0, noise(256)}});
    ASSERT_EQ(coarser.size(), 1U);
    EXPECT_LE(coarser.at(0)->size().width, 16);
}

TEST(MaskLevels, EndWithOneTexel) {
    MaskUse endless = whole(0);
    endless.area = 1e9;
    EXPECT_EQ(coarserMasks({endless}, {{0, noise(64)}}).at(0)->size(), (Size{1, 1}));
}

}  // namespace
}  // namespace inkedge::gltf
