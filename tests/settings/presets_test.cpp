#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include <inkedge/setting_table.h>

#include "base/temporary_folder.h"
#include "settings/setting_samples.h"

namespace inkedge::settings {
namespace {

using namespace setting_samples;
using testing::IsEmpty;
using testing::Not;

TEST(Presets, haveNamesOfTheirOwnAndOneLineOfHelp) {
    std::set<std::string_view> names;
    for (const Preset& preset : presets()) {
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
        EXPECT_THAT(preset.help, Not(IsEmpty()));
        EXPECT_THAT(preset.values, Not(IsEmpty()));
    }
    EXPECT_THAT(names, testing::IsSupersetOf(
                           {"paper", "blueprint", "overlay", "technical", "illustration", "plotter", "dataset"}));
}

TEST(Presets, setWhatTheySay) {
    for (const Preset& preset : presets()) {
        Settings settings;
        for (const auto& [name, text] : preset.values) {
            ASSERT_NO_THROW(set(settings, name, text, preset.name)) << preset.name << ": " << name;
        }
        for (const auto& [name, text] : preset.values) EXPECT_EQ(got(name, settings), text) << preset.name;
    }
}

TEST(Presets, paperIsTheClassicDetectorWithTheKernelsOfEquation8) {
    Settings settings;
    setPreset(settings, "paper", "test");
    EXPECT_EQ(settings.detector.detector, Detector::Classic);
    EXPECT_EQ(settings.detector.kernel, Kernel::Farid);
}

TEST(Presets, technicalHasThePensOfTechnicalDrawings) {
    Settings settings;
    setPreset(settings, "technical", "test");
    EXPECT_EQ(settings.picture.pens[0].width, (PictureLength{0.7, true})) << "outlines";
    EXPECT_EQ(settings.picture.lineWidth, (PictureLength{0.35, true})) << "creases and the others";
    EXPECT_EQ(settings.picture.hiddenPen.width, (PictureLength{0.25, true}));
    EXPECT_EQ(settings.lines.hidden, HiddenLines::Dashed);
}

TEST(Presets, plotterHasOneWidth) {
    Settings settings;
    setPreset(settings, "plotter", "test");
    EXPECT_EQ(settings.picture.pens, PictureSettings{}.pens);
    EXPECT_EQ(settings.lines.pathOrder, PathOrder::Travel);
    EXPECT_EQ(settings.lines.coincident, CoincidentLines::Merge);
    EXPECT_EQ(settings.lines.strokeWidth, StrokeWidth::Constant);
    EXPECT_EQ(settings.lines.strokeTaper, 0.0);
}

TEST(Presets, datasetHasEveryMapAndNoInk) {
    Settings settings;
    setPreset(settings, "dataset", "test");
    EXPECT_EQ(settings.maps.size(), static_cast<std::size_t>(mapCount));
    EXPECT_EQ(settings.style.style, Style::None);
}

TEST(Presets, keepWhatTheyDoNotSay) {
    Settings settings = with("size", "320x200");
    setPreset(settings, "technical", "test");
    EXPECT_EQ(settings.picture.size, (Size{320, 200}));
}

TEST(Presets, thatAreNoneAreRefused) {
    expectError(Error::Kind::Usage,
                testing::StrEq("--preset: expected one of paper, blueprint, overlay, technical, illustration, plotter, "
                               "dataset, found 'sketch'"),
                [] {
                    Settings settings;
                    setPreset(settings, "sketch", "--preset");
                });
}

// What --print-config prints.
TEST(ConfigText, readAgainIsTheSame) {
    const TemporaryFolder folder;
    for (const Preset& preset : presets()) {
        Settings settings = with("crop", "2mm");
        setPreset(settings, preset.name, "test");
        put(folder / "a.conf", configText(settings));
        Settings again;
        readConfig(again, folder / "a.conf");
        EXPECT_EQ(configText(again), configText(settings)) << preset.name;
        for (const auto& [name, text] : preset.values) EXPECT_EQ(got(name, again), got(name, settings)) << name;
    }
    EXPECT_EQ(configText({}), "");
    EXPECT_EQ(configText(with("line-width", "2")), "line-width = 2\n");
}

TEST(Thresholds, areThoseGiven) {
    DetectorSettings detector;
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        detector.kernel = kernel;
        detector.depthThreshold = 0.0F;
        detector.normalThreshold = 7.0F;
        EXPECT_EQ(thresholds(detector).depth, 0.0F);
        EXPECT_EQ(thresholds(detector).normal, 7.0F);
    }
}

TEST(Thresholds, meanTheSameStepUnderBothKernels) {
    DetectorSettings sobel;
    sobel.kernel = Kernel::Sobel;
    DetectorSettings farid;
    farid.kernel = Kernel::Farid;
    // A step of 1 has magnitude 4 under Sobel and 0.108385 + 0.280349 under Farid (whose smoothing sums to 0.999999).
    constexpr float ratio = 0.388734F / 4.0F;
    EXPECT_FLOAT_EQ(thresholds(farid).depth, thresholds(sobel).depth * ratio);
    EXPECT_FLOAT_EQ(thresholds(farid).normal, thresholds(sobel).normal * ratio);
}

// "0.1 (sobel), 0.00972 (farid)"
TEST(Thresholds, areThoseThatTheManualStates) {
    const auto stated = [](std::string_view name, Kernel kernel) {
        const auto row = std::ranges::find(settingTable(), name, &SettingDescription::name);
        const std::string text = split(row->defaultValue(), ',').at(kernel == Kernel::Sobel ? 0 : 1);
        EXPECT_NE(text.find(kernel == Kernel::Sobel ? "(sobel)" : "(farid)"), std::string::npos) << text;
        return std::stof(text);
    };
    for (const Kernel kernel : {Kernel::Sobel, Kernel::Farid}) {
        DetectorSettings detector;
        detector.kernel = kernel;
        const Thresholds inForce = thresholds(detector);
        // The manual rounds to three digits: half a unit of the third is at most 0.5 %.
        EXPECT_NEAR(stated("depth-threshold", kernel) / inForce.depth, 1.0, 0.005);
        EXPECT_NEAR(stated("normal-threshold", kernel) / inForce.normal, 1.0, 0.005);
    }
}

}  // namespace
}  // namespace inkedge::settings
