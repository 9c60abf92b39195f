#include "io/svg_path.h"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace inkedge::io {
namespace {

using testing::ElementsAre;

// The points of the lines of paths that are made of absolute moves and relative lines, in units of the path.
std::vector<std::vector<glm::dvec2>> pointsOf(const std::vector<std::string>& paths) {
    const std::regex step{R"(([mlz]?)(?: ?(-?[\d.]+) ?(-?[\d.]+))?)"};
    std::vector<std::vector<glm::dvec2>> all;
    for (const std::string& path : paths) {
        std::vector<glm::dvec2>& points = all.emplace_back();
        for (std::sregex_iterator i{path.begin(), path.end(), step}; i != std::sregex_iterator{}; ++i) {
            if ((*i)[1] == "z") points.push_back(points.front());
            if (!(*i)[2].matched) continue;
            const glm::dvec2 by{std::stod((*i)[2]), std::stod((*i)[3])};
            points.push_back(points.empty() ? by : points.back() + by);
        }
    }
    return all;
}

TEST(SvgPath, isShort) {
    SvgPath path;
    path.moveTo({10, 20.5});
    path.lineTo({10.25, 20.75});
    path.lineTo({10.25, 20.75});  // nowhere
    path.lineTo({9, 21});
    path.curveTo({9.5, 21}, {10, 21.5}, {10, 22});
    path.close();
    path.moveTo({11, 20.5});  // from where the part before began
    path.lineTo({12, 20.5});
    EXPECT_THAT(path.texts(), ElementsAre("m10 20.5.25.25-1.25.25c.5 0 1 .5 1 1zm1 0 1 0"));
}

TEST(SvgPath, losesNothingByRounding) {
    SvgPath path;
    path.moveTo({0, 0});
    for (int i = 1; i <= 1000; ++i) path.lineTo({i * 0.014, 0.0});
    double x = 0.0;
    ASSERT_EQ(path.texts().size(), 1U);
    const std::string text = path.texts().front();
    const std::regex number{R"((-?(?:\d+\.?\d*|\.\d+)) 0)"};
    for (std::sregex_iterator i{text.begin(), text.end(), number}; i != std::sregex_iterator{}; ++i) {
        x += std::stod((*i)[1].str());
    }
    EXPECT_NEAR(x, 14.0, 1e-6);
}

TEST(SvgPath, ofOnePointIsADot) {
    SvgPath path;
    path.moveTo({3, 4});
    path.lineTo({3, 4.001});
    EXPECT_THAT(path.texts(), ElementsAre("m3 4h0"));
}

TEST(SvgPath, goesOnInAnotherPathBeforeReadersCutItOff) {
    constexpr int count = 70'000;
    const auto onSpiral = [](int i) { return glm::dvec2{500 + i % 7, i / 7}; };
    for (const bool closed : {false, true}) {
        SvgPath path;
        path.moveTo(onSpiral(0));
        for (int i = 1; i < count; ++i) path.lineTo(onSpiral(i));
        if (closed) path.close();
        const auto parts = pointsOf(path.texts());
        ASSERT_EQ(parts.size(), 3U);
        std::vector<glm::dvec2> joined;
        for (const auto& part : parts) {
            EXPECT_LE(part.size(), 32'000U);
            if (!joined.empty()) {
                EXPECT_EQ(part.front(), joined.back()) << "no segment is lost";
                joined.pop_back();
            }
            joined.insert(joined.end(), part.begin(), part.end());
        }
        ASSERT_EQ(joined.size(), static_cast<std::size_t>(closed ? count + 1 : count));
        for (std::size_t i = 0; i < joined.size(); ++i)
            ASSERT_EQ(joined[i], onSpiral(static_cast<int>(i % count))) << i;
    }
}

TEST(SvgPath, goesOnInAnotherPathBetweenShortSubpaths) {
    SvgPath path;
    for (int i = 0; i < 20'000; ++i) {
        path.moveTo({i, 0});
        path.arcTo(2.0, {i, 4});
        path.lineTo({i + 1, 2});
        path.close();
    }
    const std::vector<std::string> texts = path.texts();
    EXPECT_EQ(texts.size(), 6U) << "20000 subpaths of 9 points, of which a half circle has 6";
    std::ptrdiff_t closed = 0;
    for (const std::string& text : texts) {
        EXPECT_EQ(text.back(), 'z');
        EXPECT_EQ(std::count(text.begin(), text.end(), 'm'), std::count(text.begin(), text.end(), 'z'));
        closed += std::count(text.begin(), text.end(), 'z');
    }
    EXPECT_EQ(closed, 20'000);
}

}  // namespace
}  // namespace inkedge::io
