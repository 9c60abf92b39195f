// inkedge gallery: a page of what a batch has drawn. Where there is a headless Chromium it is opened, too.
#include "cli/command.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;

class Gallery : public Command {
protected:
    void SetUp() override {
        using nlohmann::json;
        const std::string list = json{{"model", asset("cube.glb")}, {"id", "a#1/cube & <b>"}}.dump() + "\n" +
                                 json{{"model", asset("bracket.glb")}, {"id", "bracket"}}.dump() + "\n" +
                                 json{{"model", file("bad.stl", "solid x")}, {"id", "bad"}}.dump() + "\n" +
                                 json{{"model", "</script>.stl"}, {"id", "no model"}}.dump() + "\n";
        EXPECT_EQ(run({"batch", file("list", list), "-o", "out", "--size", "64x64", "--maps", "depth", "--views",
                       "turntable:2", "-q"})
                      .exitCode,
                  1);
    }
    std::string page() const { return contents(folder_ / "out/gallery.html"); }
};

TEST_F(Gallery, HoldsEveryResultAndNothingThatEndsItsScript) {
    const Outcome outcome = run({"gallery", "out"});
    expectSuccess(outcome);
    EXPECT_EQ(outcome.out, "out/gallery.html: 4 items\n");
    const std::string html = page();
    const std::string begin = "id=\"results\">";
    const std::size_t at = html.find(begin) + begin.size();
    const auto results = nlohmann::json::parse(html.substr(at, html.find("</script>", at) - at));
    ASSERT_EQ(results.size(), 4U);
    EXPECT_EQ(html.find("http"), std::string::npos) << "it needs no other page";
}

TEST_F(Gallery, IsRefusedWithoutFolders) {
    expectFailure(run({"gallery", "missing"}), 3,
                  HasSubstr("missing/results.jsonl: expected what inkedge batch wrote"));
    expectSuccess(run({"batch", file("list", asset("cube.glb")), "-o", "shards", "--size", "8x8", "--shards", "1"}));
    expectFailure(run({"gallery", "shards"}), 3, HasSubstr("found shards, whose pictures no page can show"));
}

std::string chromium() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        for (const char* folder : {"/usr/bin/", "/usr/local/bin/"})
            if (std::filesystem::exists(std::string{folder} + name)) return std::string{folder} + name;
    return {};
}

TEST_F(Gallery, ShowsCardsAndTheirPicturesInChromium) {
    if (chromium().empty()) GTEST_SKIP() << "no Chromium here";
    expectSuccess(run({"gallery", "out"}));
    const Outcome outcome =
        runCommand(chromium(),
                   {"--headless", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files",
                    "--user-data-dir=" + (folder_ / "profile").string(), "--virtual-time-budget=5000", "--dump-dom",
                    "file://" + (folder_ / "out/gallery.html").string()},
                   folder_.path());
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("All 4"), HasSubstr("Failed 2"), HasSubstr("4 of 4"),
                                   HasSubstr("a%231/cube%20%26%20%3Cb%3E/000.outline.png"),
                                   HasSubstr("a#1/cube &amp; &lt;b&gt;"), HasSubstr("class=\"bad\">refused<")));
}

}  // namespace
