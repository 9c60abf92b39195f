#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include <inkedge/setting_table.h>

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
    EXPECT_THAT(names, testing::IsSupersetOf({"paper", "blueprint", "overlay"}));
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
    const auto paper = std::ranges::find(presets(), "paper", &Preset::name);
    for (const auto& [name, text] : paper->values) set(settings, name, text, "paper");
    EXPECT_EQ(settings.detector.detector, Detector::Classic);
    EXPECT_EQ(settings.detector.kernel, Kernel::Farid);
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
