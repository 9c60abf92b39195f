// inkedge sheet: a drawing sheet of several views.
#include <cstdlib>

#include "cli/command.h"
#include "cli/decode_png.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class SheetVerb : public Command {
protected:
    Outcome sheet(const std::string& model, const std::string& output, const Arguments& more = {}) const {
        Arguments arguments{"sheet", model, "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments, withoutBackends());
    }
    std::string text(const std::string& name) const { return contents(folder_ / name); }
};

TEST_F(SheetVerb, WritesEveryFormatWithoutOpenGl) {
    for (const std::string name : {"a.pdf", "a.svg", "a.dxf", "a.PNG"}) {
        const Outcome outcome = sheet(asset("gear.glb"), name);
        expectSuccess(outcome);
        EXPECT_EQ(outcome.out + outcome.error, "");
    }
    EXPECT_THAT(text("a.pdf"), StartsWith("%PDF"));
    EXPECT_THAT(text("a.svg"), AllOf(HasSubstr("width=\"420mm\" height=\"297mm\""), HasSubstr("data-view=\"iso\""),
                                     HasSubstr("<title>gear</title>")));
    EXPECT_THAT(text("a.dxf"), EndsWith("EOF\n"));
    const std::string png = text("a.PNG");
    EXPECT_EQ(png.substr(1, 3), "PNG");
    expectSuccess(sheet(asset("gear.glb"), "{model}.pdf", {"--page", "A4"}));
    EXPECT_THAT(text("gear.pdf"), StartsWith("%PDF"));
}

TEST_F(SheetVerb, WritesTheSameBytesEachTime) {
    for (const std::string extension : {".pdf", ".svg", ".dxf", ".png"}) {
        expectSuccess(sheet(asset("bracket.glb"), "a" + extension));
        expectSuccess(sheet(asset("bracket.glb"), "b" + extension));
        EXPECT_EQ(text("a" + extension), text("b" + extension)) << extension;
        expectSuccess(sheet(asset("bracket.glb"), "b" + extension, {"--date", "2026-11-30"}));
        EXPECT_NE(text("a" + extension), text("b" + extension)) << extension;
    }
}

TEST_F(SheetVerb, HasThePagesSize) {
    if (std::system("pdfinfo -v > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "no pdfinfo (Debian: poppler-utils): the PDF is not read back";
    const std::vector<std::pair<std::string, std::string>> sizes{{"A4", "595.276 x 841.89 pts (A4)"},
                                                                 {"A4-landscape", "841.89 x 595.276 pts (A4)"},
                                                                 {"A3", "1190.55 x 841.89 pts (A3)"},
                                                                 {"A0", "3370.39 x 2383.94 pts (A0)"}};
    for (const auto& [page, size] : sizes) {
        expectSuccess(sheet(asset("gear.glb"), "a.pdf", {"--page", page, "--title", "Gear 7"}));
        const std::string said = folder_ / "said";
        EXPECT_EQ(std::system(("pdfinfo '" + (folder_ / "a.pdf").string() + "' > '" + said + "'").c_str()), 0);
        EXPECT_THAT(contents(said), AllOf(HasSubstr("Page size:       " + size), HasSubstr("Gear 7"),
                                          HasSubstr("Pages:           1"), Not(HasSubstr("Date"))));
    }
}

TEST_F(SheetVerb, TakesWhatIsSaidOfTheModelAndOfLines) {
    expectSuccess(sheet(asset("gear.glb"), "a.svg", {"--lines", "outline", "--line-color", "#123456"}));
    EXPECT_THAT(text("a.svg"), AllOf(HasSubstr("#123456"), Not(HasSubstr("crease-visible"))));
    expectSuccess(sheet(asset("gear.glb"), "b.svg", {"--up", "+Z", "--unit", "mm", "--hidden", "none"}));
    EXPECT_THAT(text("b.svg"), AllOf(HasSubstr("\"up\":\"+Z\""), Not(HasSubstr("crease-hidden"))));
}

TEST_F(SheetVerb, SaysWhatDoesNothing) {
    const std::string config = file("a.conf", "style = sumi\n");
    EXPECT_EQ(sheet(asset("gear.glb"), "a.svg", {"--config", config}).error,
              "inkedge: warning: --style does nothing: it is for inkedge render\n");
    EXPECT_EQ(sheet(asset("gear.glb"), "a.svg", {"--config", config, "-q"}).error, "");
}

TEST_F(SheetVerb, RefusesBadOptionsInOneLine) {
    const auto refused = [&](const Arguments& more, const std::string& why) {
        expectFailure(sheet(asset("gear.glb"), "a.pdf", more), 2, HasSubstr(why));
    };
    refused({"--page", "A7"}, "--page: expected A4, A3, A2, A1 or A0, with -landscape or -portrait, found 'A7'");
    refused({"--projection", "fourth"}, "--projection: expected one of first, third, found 'fourth'");
    refused({"--views", "front,side"}, "--views: expected front, back,");
    refused({"--views", "front,front"}, "--views: expected each view once");
    refused({"--scale", "1"}, "--scale: expected ");
    refused({"--scale", "1:1"}, "--scale: expected views that fit on A3, found them too large at 1:1; 1:20 fits");
    refused({"--hidden", "dotted"}, "--hidden: expected one of none, dashed, solid");
    refused({"--azimuth", "30"}, "expected what inkedge sheet takes, found '--azimuth'");
    expectFailure(sheet(asset("gear.glb"), "a.tif"), 2, HasSubstr("a.tif: expected a name that ends in .svg, .pdf,"));
    expectFailure(sheet(asset("gear.glb"), "-"), 2, HasSubstr("found no extension"));
    expectFailure(sheet(asset("gear.glb"), "missing/a.pdf"), 5, HasSubstr("expected a folder missing, found none"));
    expectFailure(sheet(asset("gear.glb"), "a.png", {"--dpi", "90000"}), 2, HasSubstr("--dpi: expected a picture of"));
    expectFailure(sheet("missing.glb", "a.pdf"), 3, HasSubstr("missing.glb: expected a file, found none"));
    expectError(sheet(emptyModel(), "a.pdf"), 3, HasSubstr("empty.gltf"));
    EXPECT_THAT(folder_.names(), IsEmpty());
}

TEST_F(SheetVerb, OfManyPartsFitsThePage) {
    expectSuccess(sheet(asset("lantern.glb"), "a.pdf",
                        {"--views", "front,back,left,right,top,bottom,iso,dimetric", "--page", "A4"}));
}

}  // namespace
