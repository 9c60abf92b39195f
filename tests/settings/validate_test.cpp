#include <limits>
#include <string>

#include <gmock/gmock.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>
#include <inkedge/surface_functions.h>

#include "base/expect_error.h"
#include "settings/setting_samples.h"

namespace inkedge::settings {
namespace {

using namespace setting_samples;
using testing::StrEq;

TEST(Validate, takesTheDefaultsAndEverySample) {
    EXPECT_NO_THROW(validate(Settings{}));
    for (const SettingDescription& row : settingTable()) {
        for (const std::string& sample : samples(row)) EXPECT_NO_THROW(validate(with(row.name, sample))) << row.name;
    }
}

void expectInvalid(const std::string& message, void (*spoil)(Settings&)) {
    Settings settings;
    spoil(settings);
    expectError(Error::Kind::Usage, StrEq(message), [&] { validate(settings); });
    expectError(Error::Kind::Usage, StrEq(message), [&] { validate(static_cast<const RenderSettings&>(settings)); });
}

TEST(Validate, refusesValuesWithTheWordsOfTheCommandLine) {
    expectInvalid("sumi-width: expected a number from 1 to 32, found '-5'",
                  [](Settings& s) { s.style.sumiWidth = -5; });
    expectInvalid("line-width: expected a number from 0.5 to 32, found '-3'",
                  [](Settings& s) { s.picture.lineWidth.value = -3; });
    expectInvalid("line-width: expected a number from 0.001 to 1000, found '0mm'", [](Settings& s) {
        s.picture.lineWidth = {0.0, true};
    });
    expectInvalid("isolines: expected a whole number from 0 to 1000, found 'u:-4,v:5000'", [](Settings& s) {
        s.lines.isolines = {-4, 5000};
    });
    expectInvalid("size: expected 1x1 to 32768x32768 pixels, found '0x5'", [](Settings& s) {
        s.picture.size = {0, 5};
    });
    expectInvalid("supersampling: expected 1, 2 or 4, found '3'", [](Settings& s) { s.picture.supersampling = 3; });
    expectInvalid("dpi: expected a number, found 'nan'",
                  [](Settings& s) { s.picture.dpi = std::numeric_limits<double>::quiet_NaN(); });
    expectInvalid("fit-curves: expected 0 or a number from 0.01 to 100, found '0.001'",
                  [](Settings& s) { s.lines.fitCurves = 0.001; });
    expectInvalid("style: expected one of ink, hatch, sumi, pencil, none, found '9'",
                  [](Settings& s) { s.style.style = static_cast<Style>(9); });
    expectInvalid("line-style: expected a number from 0.5 to 32, found 'crease:width=99'",
                  [](Settings& s) { s.picture.pens[3].width = PictureLength{99.0}; });
}

TEST(Validate, refusesFunctionsThatNoRowAllows) {
    expectInvalid(
        "function: expected one of depth, normal, texture, base-color, environment, volume, curvature, uv, "
        "height, custom, found 'nonsense'",
        [](Settings& s) { s.detector.functions.emplace_back().name = "nonsense"; });
    expectInvalid("function: height: expected 3 options, found 0",
                  [](Settings& s) { s.detector.functions.emplace_back().name = "height"; });
    Settings settings;
    settings.detector.functions = {surfaceFunction("texture")};
    settings.detector.functions[0].file = "a,b;c.png";
    EXPECT_NO_THROW(validate(settings));
}

TEST(Validate, holdsEachPartToItsOwnRows) {
    LoadSettings load;
    load.subdivide = 7;
    expectError(Error::Kind::Usage, StrEq("subdivide: expected a whole number from 0 to 6, found '7'"),
                [&] { validate(load); });
    CameraSettings camera;
    camera.zoomFactor = 0.0;
    expectError(Error::Kind::Usage, StrEq("camera-zoom-factor: expected a number from 0.001 to 1000000, found '0'"),
                [&] { validate(camera); });
    BackendSettings backend;
    backend.device = -1;
    expectError(Error::Kind::Usage, StrEq("device: expected a whole number from 0, found '-1'"),
                [&] { validate(backend); });
}

}  // namespace
}  // namespace inkedge::settings
