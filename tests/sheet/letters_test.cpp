#include "sheet/letters.h"

#include <algorithm>

#include <gmock/gmock.h>

namespace inkedge::sheet {
namespace {

// What a path goes through.
struct Trace {
    std::vector<glm::dvec2> points;
    int strokes = 0;
    void moveTo(glm::dvec2 to) {
        ++strokes;
        points.push_back(to);
    }
    void lineTo(glm::dvec2 to) { points.push_back(to); }
    void curveTo(glm::dvec2, glm::dvec2, glm::dvec2) { ADD_FAILURE() << "letters are straight"; }
    void arcTo(double, glm::dvec2) { ADD_FAILURE() << "letters are straight"; }
    void close() {}
};

Trace traceOf(std::string_view text, glm::dvec2 at = {0, 0}, double height = 10.0) {
    io::Path path;
    write(path, text, at, height);
    Trace trace;
    path.copyTo(trace);
    return trace;
}

TEST(Letters, StandOnTheLineAndAreAsHighAsAsked) {
    for (const char c : std::string_view{"ABCDEFGHIJKLMNOPRSTUVWXYZ0123456789"}) {
        const Trace trace = traceOf({&c, 1}, {50, 80}, 3.5);
        const auto [low, high] = std::ranges::minmax(trace.points, {}, &glm::dvec2::y);
        EXPECT_NEAR(high.y, 80.0, 1e-9) << c;
        EXPECT_NEAR(low.y, 76.5, 1e-9) << c;
        const auto [left, right] = std::ranges::minmax(trace.points, {}, &glm::dvec2::x);
        EXPECT_GE(left.x, 50.0 - 1e-9) << c;
        EXPECT_NEAR(right.x, 50.0 + widthOf({&c, 1}, 3.5), 1e-9) << c;
    }
}

TEST(Letters, AreAllDifferent) {
    std::vector<std::vector<glm::dvec2>> all;
    for (const char c : std::string_view{"ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:;-_+=/\\|()[]<>%&'\"#*!?@"}) {
        EXPECT_EQ(unknownIn({&c, 1}), "") << c;
        all.push_back(traceOf({&c, 1}).points);
        EXPECT_EQ(std::ranges::count(all, all.back()), 1) << c;
    }
}

TEST(Letters, OfATextFollowEachOther) {
    EXPECT_EQ(traceOf("gear").points, traceOf("GEAR").points) << "capitals";
    EXPECT_EQ(widthOf("", 5), 0.0);
    EXPECT_NEAR(widthOf("HH", 10), 6 + 2 + 6, 1e-9);
    const Trace both = traceOf("HH");
    EXPECT_NEAR(both.points.back().x - traceOf("H").points.back().x, 8.0, 1e-9);
}

TEST(Letters, HaveMarks) {
    for (const std::string_view text : {"\u00C4", "\u00E4", "\u00C9", "\u00E7", "\u00D1", "\u00C5"}) {
        EXPECT_EQ(unknownIn(text), "") << text;
        EXPECT_GT(traceOf(text).strokes, 1) << text;
    }
    for (const std::string_view text : {"\u00B0", "\u00B1", "\u00D8", "\u2300", "\u00DF", "\u2013", "\u00B5"})
        EXPECT_EQ(unknownIn(text), "") << text;
}

TEST(Letters, SayWhichTheyHaveNot) {
    EXPECT_EQ(unknownIn("A\u6B6FB\u8ECA\u6B6F"), "\u6B6F\u8ECA");
    EXPECT_EQ(unknownIn("a\xFF"), "\uFFFD") << "no UTF-8";
    EXPECT_EQ(unknownIn("a\xE6"), "\uFFFD") << "cut off";
    EXPECT_EQ(traceOf("\u6B6F").points.size(), 5U) << "a box";
    EXPECT_GT(widthOf("\u6B6F", 10), 0.0);
}

}  // namespace
}  // namespace inkedge::sheet
