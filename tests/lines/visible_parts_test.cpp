#include "lines/see/visible_parts.h"

#include <atomic>
#include <functional>

#include <gmock/gmock.h>

namespace inkedge::lines {
namespace {

using testing::DoubleEq;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::SizeIs;

constexpr double precision = 0.13;  // pixels: a change is precision to half of 0.25

// A chain along the x axis of the picture, of segments of these lengths; those that run backwards have less than 0.
struct Straight {
    Chain chain;
    std::vector<ScreenSegment> segments;
    std::vector<double> begins;

    explicit Straight(const std::vector<double>& lengths, bool closed = false) {
        double x = 0.0;
        for (std::uint32_t i = 0; i < lengths.size(); ++i) {
            const double next = x + std::abs(lengths[i]);
            ScreenSegment s{};
            const bool reversed = lengths[i] < 0.0;
            s.ends[reversed ? 1 : 0].pixel = {x, 0};
            s.ends[reversed ? 0 : 1].pixel = {next, 0};
            segments.push_back(s);
            chain.links.push_back({i, reversed});
            begins.push_back(x);
            x = next;
        }
        begins.push_back(x);
        chain.closed = closed;
    }

    // Crossings by x.
    [[nodiscard]] std::vector<Part> part(const std::function<Seen(double x)>& look,
                                         const std::vector<double>& crossingsAt = {}) const {
        std::vector<Crossing> crossings;
        std::vector<std::uint32_t> first{0};
        for (std::uint32_t s = 0; s < segments.size(); ++s) {
            const double from = segments[s].ends[0].pixel.x;
            const double step = segments[s].ends[1].pixel.x - from;
            for (const double x : crossingsAt)
                if (x > begins[s] && x < begins[s + 1]) crossings.push_back({s, (x - from) / step});
            std::sort(crossings.begin() + first.back(), crossings.end(), [](auto a, auto b) { return a.at < b.at; });
            first.push_back(static_cast<std::uint32_t>(crossings.size()));
        }
        return partChain(chain, segments, crossings, first, [&](std::uint32_t s, double at) {
            const auto& ends = segments[s].ends;
            return look(ends[0].pixel.x + at * (ends[1].pixel.x - ends[0].pixel.x));
        });
    }
    [[nodiscard]] double x(double position) const {
        const auto i = std::min(static_cast<std::size_t>(position), begins.size() - 2);
        return begins[i] + (position - double(i)) * (begins[i + 1] - begins[i]);
    }
};

Seen insideUntil(double x, double end) { return x < end ? Seen::Inside : Seen::Hidden; }

TEST(VisibleParts, OfWhatLooksTheSameAreOne) {
    const Straight line{{10.0, -7.0, 3.0}};
    EXPECT_THAT(line.part([](double) { return Seen::Outline; }), ElementsAre(FieldsAre(0.0, 3.0, Seen::Outline)));
    EXPECT_THAT(line.part([](double) { return Seen::Hidden; }, {4.0, 12.0}),
                ElementsAre(FieldsAre(0.0, 3.0, Seen::Hidden)));
}

TEST(VisibleParts, ChangeExactlyAtCrossings) {
    const Straight line{{10.0, -20.0}};
    for (const double at : {3.0, 14.0, 29.0}) {
        const auto parts = line.part([&](double x) { return insideUntil(x, at); }, {at});
        ASSERT_THAT(parts, SizeIs(2)) << at;
        EXPECT_NEAR(line.x(parts[0].end), at, 1e-12);
        EXPECT_EQ(parts[0].end, parts[1].begin);
        EXPECT_EQ(parts[1].seen, Seen::Hidden);
    }
}

TEST(VisibleParts, ChangeWithinHalfAFinestStepElsewhere) {
    const Straight line{{10.0, -20.0, 5.0, 40.0}};
    for (double at = 3.5; at < 71.0; at += 1.7) {
        const auto parts = line.part([&](double x) { return insideUntil(x, at); });
        ASSERT_THAT(parts, SizeIs(2)) << at;
        EXPECT_NEAR(line.x(parts[0].end), at, precision);
    }
}

TEST(VisibleParts, EndWhereTheyTurnBehindWithoutACrossing) {
    // The only sample between two crossings is seen; the chain goes on hidden from some point on, or up to it.
    const Straight line{{60.0}};
    for (const double at : {22.6, 23.1, 23.9, 24.4}) {
        const auto parts = line.part([&](double x) { return insideUntil(x, at); }, {20.0, 25.0});
        ASSERT_THAT(parts, SizeIs(2)) << at;
        EXPECT_NEAR(line.x(parts[0].end), at, 0.26);  // looked for in halves of a pixel
        const auto mirrored = line.part([&](double x) { return insideUntil(60.0 - x, at); }, {35.0, 40.0});
        ASSERT_THAT(mirrored, SizeIs(2)) << at;
        EXPECT_NEAR(line.x(mirrored[1].begin), 60.0 - at, 0.26);
    }
}

TEST(VisibleParts, DoNotReachOverAGapToASpeck) {
    const Straight line{{60.0}};
    const auto look = [](double x) { return x < 20.0 || (x > 22.0 && x < 22.6) ? Seen::Inside : Seen::Hidden; };
    EXPECT_THAT(line.part(look, {20.0, 22.0, 22.6}), ElementsAre(FieldsAre(0.0, DoubleEq(20.0 / 60.0), Seen::Inside),
                                                                 FieldsAre(DoubleEq(20.0 / 60.0), 1.0, Seen::Hidden)));
    const auto mirrored = [&](double x) { return look(60.0 - x); };
    EXPECT_THAT(line.part(mirrored, {37.4, 38.0, 40.0}), SizeIs(2));
    // Between two lines specks bridge it.
    const auto on = [&](double x) { return x > 24.5 ? Seen::Inside : look(x); };
    EXPECT_THAT(line.part(on, {20.0, 22.0, 22.6, 24.5}), ElementsAre(FieldsAre(0.0, 1.0, Seen::Inside)));
}

TEST(VisibleParts, HaveEveryChangeWiderThanTheSampleStep) {
    const Straight line{{33.0, 33.0, 34.0}};
    const auto parts =
        line.part([](double x) { return static_cast<int>(x / 12.5) % 2 == 0 ? Seen::Outline : Seen::Hidden; });
    ASSERT_THAT(parts, SizeIs(8));
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(line.x(parts[i].begin), 12.5 * double(i), precision);
}

TEST(VisibleParts, CoverTheChainWithoutGaps) {
    const Straight line{{0.1, 0.0, 12.0, -0.05, 30.0, 0.2}};
    const auto parts =
        line.part([](double x) { return static_cast<int>(x / 7.0) % 2 == 0 ? Seen::Inside : Seen::Hidden; },
                  {0.05, 5.0, 5.1, 7.0, 25.0, 42.3});
    EXPECT_EQ(parts.front().begin, 0.0);
    EXPECT_EQ(parts.back().end, 6.0);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        EXPECT_EQ(parts[i].begin, parts[i - 1].end);
        EXPECT_NE(parts[i].seen, parts[i - 1].seen);
    }
}

TEST(VisibleParts, FillShortGapsAndDropSpecks) {
    const Straight line{{60.0}};
    const auto partsOf = [&](double from, double to, Seen within) {
        const Seen around = isSeen(within) ? Seen::Hidden : Seen::Inside;
        return line.part([=](double x) { return x > from && x < to ? within : around; }, {from, to}).size();
    };
    EXPECT_EQ(partsOf(20.0, 20.0 + maxGap - 0.1, Seen::Hidden), 1U);
    EXPECT_EQ(partsOf(20.0, 20.0 + maxGap + 0.1, Seen::Hidden), 3U);
    EXPECT_EQ(partsOf(20.0, 20.0 + minPart - 0.1, Seen::Inside), 1U);
    EXPECT_EQ(partsOf(20.0, 20.0 + minPart + 0.1, Seen::Inside), 3U);
    // At its ends nothing says that a line goes on.
    EXPECT_EQ(partsOf(-1.0, 2.0, Seen::Hidden), 2U);
}

TEST(VisibleParts, KeepShortPiecesBesideOtherSeenOnes) {
    // Against the background, before a surface for half a pixel, hidden.
    const Straight line{{60.0}};
    const auto parts = line.part(
        [](double x) { return x < 20.0   ? Seen::Outline
                              : x < 20.5 ? Seen::Inside
                                         : Seen::Hidden; }, {20.0, 20.5});
    EXPECT_THAT(parts, ElementsAre(FieldsAre(0.0, DoubleEq(20.0 / 60.0), Seen::Outline),
                                   FieldsAre(DoubleEq(20.0 / 60.0), DoubleEq(20.5 / 60.0), Seen::Inside),
                                   FieldsAre(DoubleEq(20.5 / 60.0), 1.0, Seen::Hidden)));
}

TEST(VisibleParts, OfAChainOfSpecksAreJudgedByOne) {
    const Straight line{{0.01, 0.02, 0.0}};
    EXPECT_THAT(line.part([](double) { return Seen::Inside; }), ElementsAre(FieldsAre(0.0, 3.0, Seen::Inside)));
    const Straight none{{0.0}};
    EXPECT_THAT(none.part([](double) { return Seen::Hidden; }), ElementsAre(FieldsAre(0.0, 1.0, Seen::Hidden)));
}

TEST(VisibleParts, OfClosedChainsDoNotEndWhereTheChainBegins) {
    const Straight loop{{20.0, 20.0, 20.0}, true};
    const auto parts =
        loop.part([](double x) { return x > 25.0 && x < 35.0 ? Seen::Hidden : Seen::Outline; }, {25.0, 35.0});
    EXPECT_THAT(parts, ElementsAre(FieldsAre(DoubleEq(1.25), DoubleEq(1.75), Seen::Hidden),
                                   FieldsAre(DoubleEq(1.75), DoubleEq(4.25), Seen::Outline)));
    // Whole ones stay whole.
    EXPECT_THAT(loop.part([](double) { return Seen::Inside; }), ElementsAre(FieldsAre(0.0, 3.0, Seen::Inside)));
    // Where the start is a change, it stays one.
    EXPECT_THAT(loop.part([](double x) { return x < 30.0 ? Seen::Inside : Seen::Hidden; }, {30.0}),
                ElementsAre(FieldsAre(0.0, DoubleEq(1.5), Seen::Inside), FieldsAre(DoubleEq(1.5), 3.0, Seen::Hidden)));
}

TEST(VisibleParts, OfClosedChainsFillGapsWhereTheChainBegins) {
    const Straight loop{{20.0, 20.0, 20.0}, true};
    EXPECT_THAT(loop.part([](double x) { return x < 1.0 || x > 59.0 ? Seen::Hidden : Seen::Outline; }, {1.0, 59.0}),
                ElementsAre(FieldsAre(0.0, 3.0, Seen::Outline)));
    EXPECT_THAT(loop.part([](double x) { return x < 0.4 || x > 59.6 ? Seen::Outline : Seen::Hidden; }, {0.4, 59.6}),
                ElementsAre(FieldsAre(0.0, 3.0, Seen::Hidden)));
}

TEST(VisibleParts, AskNoMoreThanTheyNeed) {
    // An inner loop of rays: one per sample step a few a change, and one to either side of it.
    const Straight line{{600.0}};
    std::atomic<int> asked = 0;
    (void)line.part([&](double x) {
        ++asked;
        return x < 333.3 ? Seen::Inside : Seen::Hidden;
    });
    EXPECT_LE(asked, 108);
}

}  // namespace
}  // namespace inkedge::lines
