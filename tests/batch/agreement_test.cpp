#include "batch/agreement.h"

#include <gtest/gtest.h>

namespace inkedge::batch {
namespace {

Lines lines(std::initializer_list<std::vector<glm::dvec2>> of) {
    Lines all;
    all.size = {100, 60};
    for (const auto& pixels : of) {
        Line& line = all.lines.emplace_back();
        for (const glm::dvec2& pixel : pixels) line.points.push_back({pixel, {}});
    }
    return all;
}

TEST(Agreement, CountsWhatIsNear) {
    const Lines image = lines({{{10, 10}, {60, 10}}, {{10, 30}, {30, 30}}});
    const Lines object = lines({{{10, 11.4}, {60, 11.4}}, {{10, 32}, {30, 32}}, {{40, 50}, {70, 50}}});
    const Agreement found = agreementOf(image, object);
    EXPECT_NEAR(found.image, 70.0, 1e-9);
    EXPECT_NEAR(found.precision(), 50.0 / 70.0, 1e-9) << "1.4 pixels are near, 2 are not";
    EXPECT_NEAR(found.recall(), 50.0 / 100.0, 1e-9);
    EXPECT_NEAR(found.f1(), 2.0 * found.precision() * found.recall() / (found.precision() + found.recall()), 1e-12);
}

TEST(Agreement, LooksAtWhatIsSeenInThePicture) {
    Lines object = lines({{{-50, 10}, {50, 10}}, {{0, 20}, {50, 20}}});
    object.lines[1].visible = false;
    Lines image = lines({{{0, 10}, {50, 10}}});
    Agreement found = agreementOf(image, object);
    EXPECT_NEAR(found.object, 50.0, 1e-9);
    EXPECT_DOUBLE_EQ(found.f1(), 1.0);
    image.lines[0].closed = true;  // back to its start
    found = agreementOf(image, object);
    EXPECT_NEAR(found.image, 100.0, 1e-9);
    EXPECT_DOUBLE_EQ(found.f1(), 1.0);
}

TEST(Agreement, OfNothing) {
    const Lines none = lines({});
    const Lines one = lines({{{0, 10}, {50, 10}}});
    EXPECT_DOUBLE_EQ(agreementOf(none, none).f1(), 1.0);
    EXPECT_DOUBLE_EQ(agreementOf(none, one).recall(), 0.0);
    EXPECT_DOUBLE_EQ(agreementOf(none, one).precision(), 1.0);
    EXPECT_DOUBLE_EQ(agreementOf(one, none).f1(), 0.0);
    Agreement sum = agreementOf(none, one);
    sum += agreementOf(one, one);
    EXPECT_DOUBLE_EQ(sum.recall(), 0.5);
}

}  // namespace
}  // namespace inkedge::batch
