// inkedge render: which way is up, named views, sizes as people say them, several models in one call.
#include <algorithm>
#include <array>
#include <optional>
#include <regex>

#include "cli/command.h"
#include "cli/decode_png.h"

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Vertex = std::array<double, 3>;

// A wedge with no two sides alike, 4 wide, 3 deep and 2 high, its slope towards the front.
const std::vector<std::array<Vertex, 3>>& wedge() {
    static const Vertex a{0, 0, 0};
    static const Vertex b{4, 0, 0};
    static const Vertex c{4, 3, 0};
    static const Vertex d{0, 3, 0};
    static const Vertex e{0, 3, 2};
    static const Vertex f{4, 3, 1};
    static const std::vector<std::array<Vertex, 3>> all{{a, d, c}, {a, c, b}, {a, b, f}, {a, f, e},
                                                        {d, e, f}, {d, f, c}, {a, e, d}, {b, c, f}};
    return all;
}

// Four bytes of a PNG's chunk, the most significant first.
std::uint32_t numberAt(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

struct Png {
    std::uint32_t width;
    std::uint32_t height;
    std::optional<std::uint32_t> pixelsPerMetre;
};

class Sizes : public Command {
protected:
    // As CAD programs write it: Z is up.
    std::string stl(const std::string& name = "wedge.stl") const {
        std::string text = "solid wedge\n";
        for (const auto& corners : wedge()) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const Vertex& v : corners)
                text +=
                    "vertex " + std::to_string(v[0]) + ' ' + std::to_string(v[1]) + ' ' + std::to_string(v[2]) + '\n';
            text += "endloop\nendfacet\n";
        }
        return file(name, text + "endsolid wedge\n");
    }
    // The same with Y up, and its front, as before, towards the one who looks along the axis that goes away from us.
    std::string obj() const {
        std::string text;
        std::string faces;
        int number = 0;
        for (const auto& corners : wedge()) {
            faces += 'f';
            for (const Vertex& v : corners) {
                text += "v " + std::to_string(v[0]) + ' ' + std::to_string(v[2]) + ' ' + std::to_string(-v[1]) + '\n';
                faces += ' ' + std::to_string(++number);
            }
            faces += '\n';
        }
        return file("wedge.obj", text + faces);
    }

    Outcome draw(const std::string& model, const std::string& output, Arguments more = {}) const {
        Arguments arguments{"render", model, "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    std::string drawn(const std::string& model, const Arguments& more, const std::string& output = "p.png") const {
        const Outcome outcome = draw(model, output, more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return contents(folder_ / output);
    }
    static Png pngOf(const std::string& bytes) {
        Png png{numberAt(bytes, 16), numberAt(bytes, 20), {}};
        const std::size_t at = bytes.find("pHYs");
        if (at == std::string::npos) return png;
        png.pixelsPerMetre = numberAt(bytes, at + 4);
        EXPECT_EQ(numberAt(bytes, at + 8), *png.pixelsPerMetre);
        EXPECT_EQ(bytes.at(at + 12), 1) << "metres";
        return png;
    }
    // What an SVG says of its size.
    std::vector<std::string> documentOf(const std::string& svg) const {
        std::smatch found;
        const std::regex size{R"x(width="([^"]*)" height="([^"]*)" viewBox="([^"]*)")x"};
        EXPECT_TRUE(std::regex_search(svg, found, size));
        return {found[1], found[2], found[3]};
    }
    json metadataOf(const std::string& name) const { return json::parse(contents(folder_ / name)); }
};

TEST_F(Sizes, AnStlStandsUprightAsTheSameModelWithYUpDoes) {
    const std::string zUp = stl();
    const std::string yUp = obj();
    for (const Arguments& more :
         {Arguments{}, Arguments{"--azimuth", "200", "--elevation", "-10"}, Arguments{"--elevation", "90"},
          Arguments{"--view", "iso"}, Arguments{"--function", "height:levels=5"}}) {
        Arguments sized{"--size", "96x80"};
        sized.insert(sized.end(), more.begin(), more.end());
        EXPECT_EQ(drawn(zUp, sized), drawn(yUp, sized)) << (more.empty() ? "" : more.front());
    }
    for (const char* const views : {"turntable:4", "sphere:5", "front,back,left,right,top,bottom,dimetric"}) {
        const Arguments more{"--size", "64x64", "--views", views};
        expectSuccess(draw(zUp, "z_{view}.png", more));
        expectSuccess(draw(yUp, "y_{view}.png", more));
    }
    for (const std::string& name : folder_.names()) {
        if (!name.starts_with("z_")) continue;
        EXPECT_EQ(contents(folder_ / name), contents(folder_ / ('y' + name.substr(1)))) << name;
    }
    EXPECT_NE(drawn(zUp, {"--size", "64x64", "--up", "+Y"}), drawn(zUp, {"--size", "64x64"}));
    EXPECT_EQ(drawn(zUp, {"--size", "64x64", "--up", "0,0,3"}), drawn(zUp, {"--size", "64x64"}));
    EXPECT_EQ(drawn(zUp, {"--size", "64x64", "--up", "-Y"}), drawn(zUp, {"--size", "64x64", "--up=-Y"}));
}

TEST_F(Sizes, InspectNamesUp) {
    EXPECT_THAT(run({"inspect", stl()}).out, HasSubstr("\nup         +Z\n"));
    EXPECT_THAT(run({"inspect", obj()}).out, HasSubstr("\nup         +Y\n"));
    EXPECT_THAT(run({"inspect", obj(), "--up", "-x"}).out, HasSubstr("\nup         -X\n"));
    EXPECT_EQ(json::parse(run({"inspect", stl(), "--json"}).out).at("up"), (json{0.0, 0.0, 1.0}));
    EXPECT_THAT(run({"inspect", obj()}).out, Not(HasSubstr("-0,")));
}

// Front, top and side at one scale: the pictures fit together.
TEST_F(Sizes, NamedViewsShareScaleAndMiddle) {
    expectSuccess(
        draw(stl(), "{view}.png",
             {"--views", "front,top,right", "--scale", "20:1", "--metadata", "{view}.json", "--crop", "2mm"}));
    EXPECT_THAT(folder_.names(),
                ElementsAre("front.json", "front.png", "right.json", "right.png", "top.json", "top.png"));
    const json front = metadataOf("front.json");
    for (const char* const other : {"top.json", "right.json"}) {
        EXPECT_EQ(metadataOf(other).at("size"), front.at("size"));
        EXPECT_EQ(metadataOf(other).at("camera").at("orthographic_height"),
                  front.at("camera").at("orthographic_height"));
    }
    const double pixelsPerUnit =
        front.at("size").at(1).get<double>() / front.at("camera").at("orthographic_height").get<double>();
    EXPECT_NEAR(pixelsPerUnit, 20.0 * 96.0 / 25.4, 1e-6) << "STL has millimetres by convention";
    expectSuccess(draw(stl(), "{view}.png", {"--views", "front,turntable:2", "--size", "32x32"}));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "001.png"));
}

TEST_F(Sizes, ArePixelsOrPaperAndFilesHoldTheResolution) {
    const Png paper = pngOf(drawn(roof(), {"--size", "90x60mm", "--dpi", "300"}));
    EXPECT_EQ(paper.width, 1063U);
    EXPECT_EQ(paper.height, 709U);
    EXPECT_EQ(paper.pixelsPerMetre, 11811U);
    EXPECT_EQ(pngOf(drawn(roof(), {"--size", "90mmx60mm"})).pixelsPerMetre, 3780U) << "96 dpi";
    EXPECT_EQ(pngOf(drawn(roof(), {"--size", "90x60", "--dpi", "96"})).pixelsPerMetre, 3780U);
    EXPECT_EQ(pngOf(drawn(roof(), {"--size", "90x60"})).pixelsPerMetre, std::nullopt);
    const Png wide = pngOf(drawn(roof(), {"--size", "300", "--view", "front"}));
    EXPECT_EQ(wide.width, 300U);
    EXPECT_LT(wide.height, 120U) << "the roof is 2 wide and 0.36 high";
    const std::string alone = run({"render", roof(), "-o", "-", "--size", "90x60", "--dpi", "300"}).out;
    EXPECT_EQ(pngOf(alone).pixelsPerMetre, 11811U);
    (void)drawn(roof(), {"--size", "40x30", "--dpi", "300", "--maps", "depth"}, "m.png");
    EXPECT_EQ(pngOf(contents(folder_ / "m.depth.png")).pixelsPerMetre, 11811U);
}

TEST_F(Sizes, CropCutsToTheInk) {
    const Picture picture =
        decodePng(drawn(roof(), {"--size", "200x200", "--crop", "7", "--line-width", "2", "--elevation", "70"}));
    unsigned left = picture.width;
    unsigned right = 0;
    unsigned top = picture.height;
    unsigned bottom = 0;
    for (unsigned i = 0; i < picture.grey.size(); ++i) {
        if (static_cast<unsigned char>(picture.grey[i]) == 255) continue;
        left = std::min(left, i % picture.width);
        right = std::max(right, i % picture.width);
        top = std::min(top, i / picture.width);
        bottom = std::max(bottom, i / picture.width);
    }
    for (const unsigned margin : {left, top, picture.width - 1 - right, picture.height - 1 - bottom}) {
        EXPECT_GE(margin, 7U);
        EXPECT_LE(margin, 8U) << "of whole pixels";
    }
    EXPECT_EQ(std::max(picture.width, picture.height), 200U);
}

TEST_F(Sizes, VectorsHaveTheSizeOnPaperToTheLastDecimal) {
    EXPECT_THAT(documentOf(drawn(roof(), {"--size", "90x60mm", "--lines-from", "image"}, "a.svg")),
                ElementsAre("90mm", "60mm", "0 0 340.157 226.772"));
    EXPECT_THAT(documentOf(drawn(roof(), {"--size", "340x227", "--lines-from", "image"}, "b.svg")),
                ElementsAre("340", "227", "0 0 340 227"));
    // A page, and on it a drawing at its scale: 4 units are 80 mm.
    const std::string page = drawn(
        stl(),
        {"--view", "front", "--scale", "20:1", "--page-size", "A4", "--preset", "blueprint", "--lines-from", "image"},
        "c.svg");
    EXPECT_THAT(documentOf(page), ElementsAre("210mm", "297mm", "0 0 793.701 1122.52"));
    EXPECT_THAT(page,
                HasSubstr(R"(<rect class="inkedge background" width="793.701" height="1122.52" fill="#1f4e8c"/>)"));
    const Outcome small = draw(stl(), "d.svg", {"--view", "front", "--scale", "60:1", "--page-size", "A4"});
    expectFailure(small, 2, HasSubstr("--scale: expected what is drawn, 240 x 120 mm at this scale, to fit into a"));
}

TEST_F(Sizes, AUnitThatIsSaidIsThatOfTheScale) {
    const auto heightOf = [&](const Arguments& more) {
        Arguments all{"--view", "front", "--dpi", "254", "--crop", "0"};
        all.insert(all.end(), more.begin(), more.end());
        all.insert(all.end(), {"--metadata", "m.json"});
        expectSuccess(draw(stl(), "{view}.png", all));
        EXPECT_TRUE(std::filesystem::exists(folder_ / "front.png")) << "{view} of --view";
        const json metadata = metadataOf("m.json");
        return metadata.at("size").at(1).get<double>() / metadata.at("camera").at("orthographic_height").get<double>();
    };
    EXPECT_NEAR(heightOf({"--scale", "1:1"}), 10.0, 1e-6) << "pixels a millimetre";
    EXPECT_NEAR(heightOf({"--scale", "1:1", "--unit", "cm"}), 100.0, 1e-6);
    EXPECT_NEAR(heightOf({"--scale", "1:2", "--unit", "in"}), 127.0, 1e-6);
    EXPECT_NEAR(heightOf({"--scale", "1:100", "--unit", "m"}), 100.0, 1e-6);
    EXPECT_NEAR(heightOf({"--scale", "1:10", "--unit", "ft"}), 304.8, 1e-6);
    EXPECT_THAT(run({"inspect", stl(), "--unit", "in"}).out, HasSubstr("\nunit       in\n"));
    EXPECT_THAT(run({"inspect", asset("cube.glb")}).out, HasSubstr("\nunit       m\n"));
}

TEST_F(Sizes, SeveralModelsAreDrawnInOneCall) {
    const std::string first = stl("a.stl");
    const std::string second = obj();
    const Outcome outcome = run({"render", first, second, "-o", "{model}_{view}.png", "--views", "front,iso", "--size",
                                 "32x32", "--metadata", "{model}_{view}.json", "--json"});
    expectSuccess(outcome);
    EXPECT_THAT(folder_.names(), ElementsAre("a_front.json", "a_front.png", "a_iso.json", "a_iso.png",
                                             "wedge_front.json", "wedge_front.png", "wedge_iso.json", "wedge_iso.png"));
    const json all = json::parse(outcome.out);
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all.at(1).at("model"), first);
    EXPECT_EQ(all.at(2).at("model"), second);
    EXPECT_EQ(all.at(3).at("files"), json{"wedge_iso.png"});
    expectFailure(run({"render", first, second, "-o", "a.png"}), 2, HasSubstr("put {model}"));
    expectFailure(run({"render", first, second, "-o", "-"}), 2,
                  HasSubstr("--output: expected a FILE with {model} for 2 models, found -"));
}

TEST_F(Sizes, NodesAreDrawnOrLeftOutByName) {
    const auto triangles = [&](const Arguments& more) {
        Arguments sized{"--size", "32x32", "--metadata", "m.json"};
        sized.insert(sized.end(), more.begin(), more.end());
        expectSuccess(draw(asset("lantern.glb"), "p.png", sized));
        return metadataOf("m.json").at("triangles").get<int>();
    };
    EXPECT_EQ(triangles({}), 70);
    EXPECT_EQ(triangles({"--only", "cup"}), 10);
    EXPECT_EQ(triangles({"--only", "lantern"}), 12) << "and what belongs to it";
    EXPECT_EQ(triangles({"--only", "cup", "--only", "leaf"}), 68);
    EXPECT_EQ(triangles({"--hide", "lantern/p*"}), 68);
    EXPECT_THAT(draw(asset("lantern.glb"), "p.png", {"--hide", "leg", "--size", "32x32"}).error,
                testing::EndsWith("lantern.glb: --hide: no node is named 'leg'\n"));
    expectFailure(
        draw(asset("lantern.glb"), "q.png", {"--only", "leg"}), 2,
        HasSubstr("--only: expected a node to draw, found none for 'leg'; there are cup, lantern, leaf, pane"));
}

TEST_F(Sizes, AFlagThatCannotActSaysSo) {
    const Outcome outcome =
        draw(roof(), "p.png", {"--size", "32x32", "--page-size", "A4", "--fit-curves", "1", "--detector", "classic"});
    expectSuccess(outcome);
    EXPECT_EQ(outcome.error,
              "inkedge: warning: --page-size does nothing: it is for .svg, .pdf and .dxf; --size takes millimetres\n"
              "inkedge: warning: --fit-curves does nothing: it is for lines in .svg, .pdf and .dxf\n");
    EXPECT_EQ(draw(roof(), "p.png", {"--size", "32x32", "--page-size", "A4", "-q"}).error, "");
    EXPECT_EQ(draw(roof(), "p.png", {"--size", "32x32", "--line-width", "3"}).error, "");
    EXPECT_EQ(run({"render", roof(), "-o", "p.png", "--size", "32x32"}, {{"INKEDGE_LINE_WIDHT", "3"}}).error,
              "inkedge: warning: INKEDGE_LINE_WIDHT does nothing: no setting has this name\n");
}

}  // namespace
