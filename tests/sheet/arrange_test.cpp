#include "sheet/arrange.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "sheet/page.h"
#include "sheet/scales.h"

namespace inkedge::sheet {
namespace {

using enum NamedView;
using testing::Contains;
using testing::ElementsAre;

constexpr double exact = 0.01;  // mm

Space spaceOf(const SheetPage& page) { return {framed(page), titleBlock(page), 10.0}; }

// The views of a box as wide, high and deep as this.
std::vector<ViewExtent> viewsOf(glm::dvec3 box, const std::vector<NamedView>& views) {
    std::vector<ViewExtent> extents;
    for (const NamedView view : views) {
        glm::dvec2 size{box.x, box.y};
        if (view == Left || view == Right) size = {box.z, box.y};
        if (view == Top || view == Bottom) size = {box.x, box.z};
        if (!isPrincipal(view)) size = {0.8 * (box.x + box.z), 0.5 * (box.x + box.z) + box.y};
        extents.push_back({view, size});
    }
    return extents;
}

const std::vector<NamedView> allViews{Front, Back, Left, Right, Top, Bottom, Iso, Dimetric};

TEST(Arranged, PutsViewsWhereTheProjectionHasThem) {
    const auto extents = viewsOf({40, 30, 20}, allViews);
    for (const Projection projection : {Projection::First, Projection::Third}) {
        const auto found = arranged(extents, projection, spaceOf({2, true}), 1.0);
        ASSERT_TRUE(found);
        const auto& at = found->middles;  // in the order of allViews
        const double away = projection == Projection::First ? 1.0 : -1.0;
        EXPECT_GT(away * (at[2].x - at[0].x), 30.0) << "left";
        EXPECT_LT(away * (at[3].x - at[0].x), -30.0) << "right";
        EXPECT_GT(away * (at[4].y - at[0].y), 25.0) << "top; y is down";
        EXPECT_LT(away * (at[5].y - at[0].y), -25.0) << "bottom";
        EXPECT_GT(at[1].x, at[0].x + 40.0) << "back";
        for (const std::size_t beside : {1U, 2U, 3U}) EXPECT_NEAR(at[beside].y, at[0].y, exact);
        for (const std::size_t above : {4U, 5U}) EXPECT_NEAR(at[above].x, at[0].x, exact);
    }
}

TEST(Arranged, LeavesGapsAroundEveryViewWhateverTheShapeAndThePage) {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> exponent{-1.0, 1.0};
    const std::vector<std::vector<NamedView>> choices{
        {Front, Top, Right, Iso}, allViews, {Iso}, {Top, Dimetric, Iso}, {Back}, {Left, Bottom}, {Iso, Front, Back}};
    int count = 0;
    for (int trial = 0; trial < 30; ++trial) {
        const glm::dvec3 box{std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random)),
                             std::pow(10.0, exponent(random))};
        for (const auto& views : choices) {
            for (const SheetPage page : {SheetPage{4, false}, {4, true}, {3, true}, {0, false}}) {
                for (const Projection projection : {Projection::First, Projection::Third}) {
                    const Space space = spaceOf(page);
                    const auto extents = viewsOf(box, views);
                    const auto found = arranged(extents, projection, space, {});
                    ASSERT_TRUE(found);
                    ++count;
                    std::vector<Rect> rects{space.titleBlock};
                    for (std::size_t i = 0; i < extents.size(); ++i) {
                        const glm::dvec2 half = 0.5 * found->scale * extents[i].size;
                        rects.push_back({found->middles[i] - half, found->middles[i] + half});
                        EXPECT_GE(rects.back().low.x, space.framed.low.x + 5.0 - exact);
                        EXPECT_GE(rects.back().low.y, space.framed.low.y + 5.0 - exact);
                        EXPECT_LE(rects.back().high.x, space.framed.high.x - 5.0 + exact);
                        EXPECT_LE(rects.back().high.y, space.framed.high.y - 5.0 + exact);
                    }
                    for (std::size_t i = 0; i < rects.size(); ++i) {
                        for (std::size_t k = 0; k < i; ++k)
                            EXPECT_FALSE(rects[i].grown(2.5 - exact).overlaps(rects[k].grown(2.5 - exact)))
                                << "views " << i << " and " << k;
                    }
                    EXPECT_THAT(standardScales(), Contains(found->scale));
                    const auto larger = std::ranges::find(standardScales(), found->scale);
                    if (larger != standardScales().begin()) {
                        EXPECT_FALSE(arranged(extents, projection, space, *std::prev(larger)))
                            << "a larger scale fits, too";
                    }
                }
            }
        }
    }
    EXPECT_EQ(count, 1680);
}

TEST(Arranged, FindsWhatFitsAndWhatDoesNot) {
    const Space space = spaceOf({3, true});
    const auto extents = viewsOf({100, 60, 40}, {Front, Top, Right});
    EXPECT_EQ(arranged(extents, Projection::First, space, {})->scale, 2.0);
    EXPECT_TRUE(arranged(extents, Projection::First, space, 0.3));
    EXPECT_FALSE(arranged(extents, Projection::First, space, 5.0));
    const auto flat = arranged(viewsOf({100, 0, 0}, {Front, Top, Right}), Projection::Third, space, {});
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->scale, 2.0);
    EXPECT_EQ(arranged(viewsOf({0, 0, 0}, {Front, Iso}), Projection::Third, space, {})->scale, 1.0) << "a point";
}

TEST(StandardScales, AreThoseOfIso5455TheLargestFirst) {
    std::vector<double> near;
    for (const double scale : standardScales())
        if (scale < 51.0 && scale > 0.009) near.push_back(scale);
    EXPECT_THAT(near, ElementsAre(50, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01));
    EXPECT_TRUE(std::ranges::is_sorted(standardScales(), std::greater<>{}));
}

TEST(Page, HasTheSizesOfIso216AndTheMarginsOfIso5457) {
    EXPECT_EQ(sizeOf({3, true}), (glm::dvec2{420, 297}));
    EXPECT_EQ(sizeOf({4, false}), (glm::dvec2{210, 297}));
    EXPECT_EQ(sizeOf({0, true}), (glm::dvec2{1189, 841}));
    EXPECT_EQ(nameOf({4, false}), "A4");
    EXPECT_EQ(nameOf({4, true}), "A4-landscape");
    EXPECT_EQ(nameOf({1, false}), "A1-portrait");
    EXPECT_EQ(framed({3, true}).low, (glm::dvec2{20, 10}));
    EXPECT_EQ(framed({3, true}).high, (glm::dvec2{410, 287}));
    EXPECT_EQ(titleBlock({4, false}).size().x, framed({4, false}).size().x) << "180 mm";
}

}  // namespace
}  // namespace inkedge::sheet
