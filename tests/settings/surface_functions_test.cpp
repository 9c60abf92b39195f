#include <inkedge/surface_functions.h>

#include <gmock/gmock.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

namespace inkedge::settings {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusalOf(std::string_view text) {
    try {
        (void)surfaceFunction(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Usage);
        return error.what();
    }
    return {};
}

TEST(SurfaceFunctions, haveTheirRowsDefaults) {
    const FunctionSettings height = surfaceFunction("height");
    EXPECT_THAT(height.options, ElementsAre(3.0, 0.0, 16.0));
    EXPECT_EQ(threshold(height), 2.0F);
    EXPECT_EQ(text(height), "height");
}

TEST(SurfaceFunctions, takeOptionsByName) {
    const FunctionSettings height = surfaceFunction("height:axis=z,step=0.25,kernel=farid,threshold=0.5");
    EXPECT_THAT(height.options, ElementsAre(2.0, 0.25, 16.0));
    EXPECT_EQ(height.kernel, Kernel::Farid);
    EXPECT_EQ(threshold(height), 0.5F);
    EXPECT_EQ(text(height), "height:axis=z,step=0.25,kernel=farid,threshold=0.5");
}

TEST(SurfaceFunctions, takeAFileFirstOrByName) {
    EXPECT_EQ(surfaceFunction("custom:mine.glsl,a=2").file, "mine.glsl");
    EXPECT_EQ(surfaceFunction("custom:a=2,file=mine.glsl").file, "mine.glsl");
    EXPECT_EQ(text(surfaceFunction("texture:clouds.png,repeat=2")), "texture:file=clouds.png,repeat=2");
}

TEST(SurfaceFunctions, keepTheirMeaningAsText) {
    for (const FunctionDescription& row : functionTable()) {
        std::string asked = std::string{row.name} + (row.file.empty() ? ":" : ":file=f,") + "threshold=0.125";
        for (const FunctionOption& option : row.options) {
            asked += "," + std::string{option.name} + "=";
            asked += option.choices.empty() ? "1" : std::string{option.choices.back()};
        }
        const FunctionSettings function = surfaceFunction(asked);
        const FunctionSettings again = surfaceFunction(text(function));
        EXPECT_EQ(again.name, function.name);
        EXPECT_EQ(again.options, function.options) << text(function);
        EXPECT_EQ(again.file, function.file);
        EXPECT_EQ(again.threshold, function.threshold);
    }
}

TEST(SurfaceFunctions, haveAStepsThresholdUnderBothKernels) {
    // A step of 1 has magnitude 4 under Sobel's kernels and 0.388734 under Farid's.
    const float sobel = threshold(surfaceFunction("uv"));
    EXPECT_FLOAT_EQ(threshold(surfaceFunction("uv:kernel=farid")), sobel * 0.388734F / 4.0F);
}

TEST(SurfaceFunctions, areTakenModuloWhatTheyRepeatAfter) {
    EXPECT_EQ(wrapPeriod(surfaceFunction("texture:repeat=3")), 1.0);
    EXPECT_EQ(wrapPeriod(surfaceFunction("texture:picture.png")), 0.0);
    EXPECT_EQ(wrapPeriod(surfaceFunction("uv:step=0.125")), 8.0);
    EXPECT_EQ(wrapPeriod(surfaceFunction("height")), 0.0);
}

TEST(SurfaceFunctions, sayWhatIsAllowed) {
    EXPECT_EQ(refusalOf("heights"),
              "expected one of depth, normal, texture, base-color, environment, volume, curvature, uv, height, custom, "
              "found 'heights'; is it height?");
    EXPECT_EQ(refusalOf("depth:map=log"),
              "depth: expected map=linear|window, kernel=sobel|farid, threshold=0.., found 'map=log'");
    EXPECT_THAT(refusalOf("uv:step=0"), HasSubstr("step=0.0001..1"));
    EXPECT_THAT(refusalOf("uv:step=x"), HasSubstr("found 'step=x'"));
    EXPECT_THAT(refusalOf("uv:size=0.1"), HasSubstr("found 'size=0.1'"));
    EXPECT_THAT(refusalOf("normal:"), HasSubstr("found ''"));
    EXPECT_THAT(refusalOf("normal:file=x.png"), HasSubstr("found 'file=x.png'"));
    EXPECT_THAT(refusalOf("depth:threshold=-1"), HasSubstr("threshold=0.."));
    EXPECT_THAT(refusalOf("custom"), HasSubstr("file=GLSL"));
}

TEST(FunctionSetting, takesSeveral) {
    Settings settings;
    set(settings, "function", "height:axis=y,step=0.1; uv:step=0.125", "--function");
    ASSERT_EQ(settings.detector.functions.size(), 2U);
    EXPECT_EQ(settings.detector.functions[1].name, "uv");
    try {
        set(settings, "function", "depth;uv:step=2", "--function");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "--function: uv: expected step=0.0001..1, direction=both|u|v, kernel=sobel|farid, threshold=0.., "
                     "found 'step=2'");
    }
}

TEST(FunctionSetting, hasTheModelLoadedWithWhatFunctionsRead) {
    Settings settings;
    EXPECT_FALSE(loadSettings(settings).textureCoordinates || loadSettings(settings).paint ||
                 loadSettings(settings).curvature);
    set(settings, "function", "uv;curvature", "");
    EXPECT_TRUE(loadSettings(settings).textureCoordinates);
    EXPECT_TRUE(loadSettings(settings).curvature);
    EXPECT_FALSE(loadSettings(settings).paint);
    set(settings, "function", "base-color", "");
    EXPECT_TRUE(loadSettings(settings).paint);
    EXPECT_FALSE(loadSettings(settings).textureCoordinates);
}

}  // namespace
}  // namespace inkedge::settings
