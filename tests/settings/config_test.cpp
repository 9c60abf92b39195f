#include <inkedge/setting_table.h>

#include <string>

#include <gmock/gmock.h>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"

namespace inkedge::settings {
namespace {

using testing::HasSubstr;

class ReadConfig : public testing::Test {
protected:
    [[nodiscard]] Settings settingsOf(const std::string& content) const {
        put(folder_ / "a.conf", content);
        Settings settings;
        readConfig(settings, folder_ / "a.conf");
        return settings;
    }

    void expectRefusal(const std::string& content, Error::Kind kind, const std::string& text) const {
        try {
            static_cast<void>(settingsOf(content));
            ADD_FAILURE() << "accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), kind);
            EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("a.conf"), HasSubstr(text)));
            EXPECT_LT(std::string{error.what()}.size(), 5000U);
        }
    }

    TemporaryFolder folder_;
};

TEST_F(ReadConfig, takesNamesAndValuesQuotedOrNotAndSkipsComments) {
    const Settings settings =
        settingsOf("# size = 1x1\n\n  size=3x4 \r\nline-color = \"#ff0000\"\ndpi = 300\ndpi = 200");
    EXPECT_EQ(settings.picture.size, (Size{3, 4}));
    EXPECT_EQ(settings.picture.lineColor, (Color{255, 0, 0}));
    EXPECT_EQ(settings.picture.dpi, 200.0);
}

TEST_F(ReadConfig, takesSecondNames) {
    EXPECT_EQ(settingsOf("azimuth = 30").camera.azimuthAngle, 30.0);
    EXPECT_EQ(settingsOf("fov = 20").camera.viewAngle, 20.0);
}

TEST_F(ReadConfig, namesTheLineThatIsWrong) {
    expectRefusal("\nsize 3x3\n", Error::Kind::Usage, "a.conf:2: expected name = value, found 'size 3x3'");
    expectRefusal("colour = red", Error::Kind::Usage, "a.conf:1: expected the name of a setting, found 'colour'");
    expectRefusal("#\n#\nsize = 0x0", Error::Kind::Usage, "a.conf:3: size: expected ");
}

TEST_F(ReadConfig, refusesWhatIsNoTextOrHasNoEnd) {
    expectRefusal("line-color = \x1b[31m", Error::Kind::Usage,
                  "a.conf:1: expected text, found the control character 27");
    expectRefusal(std::string("size = 3x3\0\n", 12), Error::Kind::Usage,
                  "expected text, found the control character 0");
    expectRefusal("size = " + std::string(5000, '9'), Error::Kind::Usage,
                  "expected lines of at most 4096 bytes, found 5007");
    expectRefusal(std::string((1U << 20U) + 1, '\n'), Error::Kind::Input, "of at most 1048576 bytes, found more");
}

TEST_F(ReadConfig, refusesWhatCannotBeRead) {
    Settings settings;
    EXPECT_THROW(readConfig(settings, folder_ / "missing.conf"), Error);
    EXPECT_THROW(readConfig(settings, folder_.path()), Error);
    if (std::filesystem::exists("/dev/zero")) {
        EXPECT_THROW(readConfig(settings, "/dev/zero"), Error);
    }
}

}  // namespace
}  // namespace inkedge::settings
