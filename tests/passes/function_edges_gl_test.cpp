#include "passes/function_edges.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "gl/gl_test.h"
#include "gl/read_back.h"

namespace inkedge::passes {
namespace {

INKEDGE_ON_EACH_BACKEND(FunctionEdges);

// Values with a channel's range each, on a surface with holes and a border of background.
Image<float> randomValues(Size of, float range, std::mt19937& random) {
    std::uniform_real_distribution<float> value{0.0F, range};
    Image<float> values{of, 4};
    for (int y = 0; y < of.height; ++y) {
        for (int x = 0; x < of.width; ++x) {
            const bool hole = x > of.width / 2 && (random() % 8 == 0 || y > 3 * of.height / 4);
            for (int c = 0; c < 4; ++c) values.at(x, y, c) = hole ? 0.0F : value(random) / static_cast<float>(1 + c);
            if (hole) values.at(x, y, 3) = 1e30F;
        }
    }
    return values;
}

// Two ramps that begin anew at the period now and then, so that some blocks hold a seam and some hold none.
Image<float> seams(Size of, float period, float slope) {
    Image<float> values{of, 4};
    for (int y = 0; y < of.height; ++y) {
        for (int x = 0; x < of.width; ++x) {
            values.at(x, y, 0) =
                std::fmod(slope * static_cast<float>(x) + 0.3F * slope * static_cast<float>(y), period);
            values.at(x, y, 1) = std::fmod(0.5F * slope * static_cast<float>(y), period);
            if ((x / 16 + y / 16) % 3 == 0) values.at(x, y, 3) = 1e30F;
        }
    }
    return values;
}

Image<float> inSteps(Image<float> values) {
    for (float& v : values.mutablePixels()) v = std::floor(v);
    return values;
}

gl::Texture uploaded(gl::Gpu& gpu, const Image<float>& values) {
    gl::Texture texture = gpu.textures.acquire(values.size(), GL_RGBA32F);
    gpu.api.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gpu.api.TextureSubImage2D(texture.id(), 0, 0, 0, values.size().width, values.size().height, GL_RGBA, GL_FLOAT,
                              values.pixels().data());
    return texture;
}

// Pixels that the pass in blocks marks otherwise than the magnitudes say, where those differ from T by more than a
// tolerance. Every T is one of the magnitudes: with no tolerance a bit's difference would show.
int wronglyMarked(gl::Gpu& gpu, const Image<float>& values, FunctionSettings function, float tolerance) {
    const gl::Texture drawn = uploaded(gpu, values);
    const Image<float> magnitude = gl::readFloats(gpu.api, measureFunction(gpu, drawn, function), 1);
    std::mt19937 random{2};
    int wrong = 0;
    for (int trial = 0; trial < 8; ++trial) {
        const float threshold = magnitude.pixels()[random() % magnitude.pixels().size()];
        function.threshold = threshold;
        const EdgeMarks marks{values.size(), gl::readIntegers(gpu.api, detectFunction(gpu, drawn, function))};
        const Image<std::uint8_t> edges = mask(marks, EdgeMarks::functionEdge);
        for (std::size_t i = 0; i < edges.pixels().size(); ++i) {
            const float m = magnitude.pixels()[i];
            if (edges.pixels()[i] != (m >= threshold ? 255 : 0) && std::abs(m - threshold) >= tolerance) ++wrong;
        }
    }
    return wrong;
}

TEST_P(FunctionEdges, areMarkedInBlocksAsTheyAreMeasuredPixelByPixel) {
    const gl::Current current{context()};
    std::mt19937 random{1};
    for (const Size each : {Size{1, 1}, Size{3, 5}, Size{4, 4}, Size{17, 33}, Size{250, 131}}) {
        for (const char* const kernel : {"kernel=sobel", "kernel=farid"}) {
            SCOPED_TRACE(testing::Message() << each.width << "x" << each.height << ", " << kernel);
            const auto function = [&](std::string name) { return surfaceFunction(name + kernel); };
            EXPECT_EQ(wronglyMarked(gpu(), randomValues(each, 30.0F, random), function("height:"), 0.0F), 0);
            // Wrapped differences are summed in another order: steps under Sobel's kernels are whole numbers all the
            // same, others are rounded by some 1e-6 of the largest sum, about 10 periods.
            const bool sobel = surfaceFunction(std::string{"uv:"} + kernel).kernel == Kernel::Sobel;
            const float rounding = sobel ? 0.0F : 1e-5F;
            for (const float slope : {0.02F, 0.3F, 3.0F}) {
                EXPECT_EQ(wronglyMarked(gpu(), seams(each, 1.0F, slope), function("texture:"), 1e-5F), 0) << slope;
                EXPECT_EQ(wronglyMarked(gpu(), inSteps(seams(each, 8.0F, slope)), function("uv:"), 8 * rounding), 0);
            }
        }
    }
}

TEST_P(FunctionEdges, ofLargeValuesThatStayTheSameHaveNoEdges) {
    const gl::Current current{context()};
    std::mt19937 random{3};
    Image<float> values = randomValues({64, 48}, 1.0F, random);
    for (std::size_t i = 0; i < values.pixels().size(); ++i)
        if (i % 4 != 3 && values.pixels()[i - i % 4 + 3] < 1e29F) values.mutablePixels()[i] = 12'345'677.0F;
    for (std::size_t i = 3; i < values.pixels().size(); i += 4)
        if (values.pixels()[i] < 1e29F) values.mutablePixels()[i] = 0.0F;
    for (const char* const kernel : {"height:kernel=sobel", "height:kernel=farid"}) {
        const gl::Texture drawn = uploaded(gpu(), values);
        const Image<float> magnitude =
            gl::readFloats(gpu().api, measureFunction(gpu(), drawn, surfaceFunction(kernel)), 1);
        EXPECT_THAT(magnitude.pixels(), testing::Each(0.0F)) << kernel;
    }
}

}  // namespace
}  // namespace inkedge::passes
