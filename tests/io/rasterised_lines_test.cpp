// What other programs draw of our files of vectors is what we paint ourselves.
#include <cstdlib>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <inkedge/write.h>

#include "base/temporary_folder.h"
#include "curves/curves.h"
#include "images/read_png.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"
#include "io/lines_to_write.h"

namespace inkedge::io {
namespace {

using curves::closedThrough;

// How another program draws a file of lines.
struct Rasteriser {
    std::string program;
    std::string package;  // of Debian
    std::string extension;
    std::string options;  // an extension follows, if the program does not add it
    std::string extensionOfPicture;
    int samples;  // along each axis of a pixel
};
const Rasteriser librsvg{"rsvg-convert", "librsvg2-bin", ".svg", "-o", ".png", 1};
// It moves strokes to whole samples.
const Rasteriser poppler{"pdftocairo", "poppler-utils", ".pdf", "-png -singlefile -r 384", "", 4};

bool isInstalled(const Rasteriser& by) { return std::system((by.program + " -v > /dev/null 2>&1").c_str()) == 0; }

double level(const Image<float>& image, int x, int y) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += image.at(x, y, image.channels() >= 3 ? k : 0);
    return sum / 3.0;
}

// The mean of each pixel's samples.
Image<float> averaged(const Image<float>& image, int samples) {
    Image<float> mean{{image.size().width / samples, image.size().height / samples}, 1};
    for (int y = 0; y < mean.size().height * samples; ++y) {
        for (int x = 0; x < mean.size().width * samples; ++x)
            mean(x / samples, y / samples) += static_cast<float>(level(image, x, y) / (samples * samples));
    }
    return mean;
}

// Grey 0..1.
Image<float> rasterised(const TemporaryFolder& folder, const Lines& lines, const Settings& settings,
                        const Rasteriser& by) {
    const std::string file = folder / ("lines" + by.extension);
    writeLines(lines, settings, file);
    const std::string picture = folder / "lines";
    const std::string options = by.extensionOfPicture.empty()
                                    ? fmt::format("{} '{}' '{}'", by.options, file, picture)
                                    : fmt::format("'{}' {} '{}{}'", file, by.options, picture, by.extensionOfPicture);
    if (std::system(fmt::format("{} {}", by.program, options).c_str()) != 0) return {};
    return averaged(images::readPng(bytesOf(contents(picture + ".png"))).image, by.samples);
}

void expectAsPainted(const Rasteriser& by) {
    const TemporaryFolder folder;
    const Size size{400, 300};
    Line thin = curves::circle({200, 140}, 60, 700);
    thin.width = 0.3;
    const Lines lines =
        linesOf({curves::circle({180, 150}, 100, 700), thin, typed(curves::winding(700, 0.1, 2), LineType::Crease),
                 hidden(typed(curves::winding(700, 0.1, 3), LineType::Crease)),
                 typed(closedThrough({{300, 200}, {450, 250}, {320, 290}}), LineType::Boundary)},
                size);
    for (const std::string widths : {"constant", "depth", "curvature"}) {
        for (const std::string curvesWithin : {"0", "0.1"}) {
            for (const std::string hiddenLines : {"dashed", "solid"}) {
                Settings settings = settingsOf({{"size", "400x300"},
                                                {"line-width", "2.5"},
                                                {"line-style", "crease:color=#0a0;boundary:width=6"},
                                                {"simplify", "0.1"},
                                                {"fit-curves", curvesWithin},
                                                {"stroke-width", widths},
                                                {"stroke-taper", widths == "curvature" ? "15" : "0"},
                                                {"hidden", hiddenLines}});
                const Image<float> drawn = rasterised(folder, lines, settings, by);
                ASSERT_EQ(drawn.size(), size);
                const auto strokes = ink::strokesOf(lines, settings.picture, settings.lines);
                const Image<std::uint8_t> painted = ink::paintStrokes(strokes, settings.picture);
                double sum = 0.0;
                double ink = 0.0;
                for (int y = 0; y < size.height; ++y) {
                    for (int x = 0; x < size.width; ++x) {
                        double there = 0.0;
                        for (int k = 0; k < painted.channels(); ++k) there += painted.at(x, y, k);
                        there /= 255.0 * painted.channels();
                        sum += std::abs(there - level(drawn, x, y));
                        ink += 1.0 - there;
                    }
                }
                // A shift by d pixels changes a line w wide by 2 d / w of its ink: the files' lines stray by 0.1 pixel
                // at most, which is 0.08 for the common width, and by a fourth of that on average. Measured: 0.014 to
                // 0.024.
                EXPECT_LT(sum / ink, 0.04) << widths << ' ' << curvesWithin << ' ' << hiddenLines;
                EXPECT_GT(ink, 2000.0);
            }
        }
    }
}

TEST(LinesSvg, looksInLibrsvgAsThePaintedPictureDoes) {
    if (!isInstalled(librsvg)) GTEST_SKIP() << "no rsvg-convert (Debian: librsvg2-bin): the SVG is not looked at";
    expectAsPainted(librsvg);
}

TEST(LinesPdf, looksInPopplerAsThePaintedPictureDoes) {
    if (!isInstalled(poppler)) GTEST_SKIP() << "no pdftocairo (Debian: poppler-utils): the PDF is not looked at";
    expectAsPainted(poppler);
}

}  // namespace
}  // namespace inkedge::io
