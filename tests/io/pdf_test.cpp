#include <inkedge/write.h>

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "curves/curves.h"
#include "io/lines_to_write.h"

namespace inkedge::io {
namespace {

using testing::HasSubstr;
using testing::Not;

// What pdfinfo says of a file; empty: there is no pdfinfo.
std::string info(const std::vector<std::uint8_t>& pdf) {
    if (std::system("pdfinfo -v > /dev/null 2>&1") != 0) return {};
    const TemporaryFolder folder;
    put(folder / "a.pdf", {pdf.begin(), pdf.end()});
    const std::string said = folder / "said";
    EXPECT_EQ(std::system(fmt::format("pdfinfo '{}' > '{}' 2>&1", (folder / "a.pdf").string(), said).c_str()), 0);
    return contents(said);
}

TEST(LinesPdf, isTheSameEachTime) {
    const Lines lines = linesOf({curves::circle({90, 50}, 40, 300)});
    const std::vector<std::uint8_t> pdf = linesPdf(lines, {}, "a");
    EXPECT_EQ(pdf, linesPdf(lines, {}, "a"));
    EXPECT_NE(pdf, linesPdf(lines, {}, "b"));
}

TEST(LinesPdf, hasThePagesSizeItsTitleAndNoDate) {
    const Lines lines = linesOf({curves::lineThrough({{1, 1}, {190, 90}})});
    const auto said = [&](const std::vector<std::pair<std::string, std::string>>& values, std::string_view title) {
        return info(linesPdf(lines, settingsOf(values), title));
    };
    if (said({}, "a").empty()) GTEST_SKIP() << "no pdfinfo (Debian: poppler-utils): the PDF is not read back";
    EXPECT_THAT(said({{"page-size", "A4"}}, "gear & \xC3\xA4"),
                HasSubstr("Page size:       595.276 x 841.89 pts (A4)"));
    EXPECT_THAT(said({{"page-size", "A4"}}, "gear & \xC3\xA4"), HasSubstr("gear & \xC3\xA4"));
    EXPECT_THAT(said({}, "a"), HasSubstr("Page size:       150 x 75 pts")) << "pixels are 1 / 96 inch";
    EXPECT_THAT(said({{"dpi", "144"}}, "a"), HasSubstr("Page size:       100 x 50 pts"));
    EXPECT_THAT(said({}, "a"), Not(HasSubstr("Date")));
    EXPECT_THAT(said({}, "broken \xFF name"), HasSubstr("broken \xEF\xBF\xBD name"));
}

TEST(LinesPdf, refusesWhatIsNoDrawing) {
    expectError(Error::Kind::Usage, HasSubstr("at least one pixel"), [] { (void)linesPdf({}, {}); });
    expectError(Error::Kind::Usage, HasSubstr("brush: expected a picture of pixels"), [] {
        (void)linesPdf(linesOf({}), settingsOf({{"brush", "dry.png"}}));
    });
}

}  // namespace
}  // namespace inkedge::io
