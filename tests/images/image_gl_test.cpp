// Draws every case of cases.json on every backend and compares it with reference_images/<case>.png. The candidate, and
// where it differs a picture of the differences, stay in the build tree; tools/accept_reference makes candidates
// references.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/camera.h>
#include <inkedge/compare.h>
#include <inkedge/load_scene.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>
#include <inkedge/setting_table.h>
#include <inkedge/sheet.h>
#include <inkedge/write.h>

namespace inkedge {
namespace {

namespace fs = std::filesystem;

const fs::path source{INKEDGE_SOURCE_DIR};

struct Case {
    std::string name;
    fs::path asset;
    Settings settings;
    std::optional<Map> map;              ///< this map instead of the picture
    std::optional<SheetSettings> sheet;  ///< a drawing sheet instead of it
    Tolerance tolerance;
};

std::ostream& operator<<(std::ostream& stream, const Case& c) { return stream << c.name; }

// As on the command line: --name value ...
Settings settingsFrom(const std::string& arguments) {
    Settings settings;
    std::istringstream words{arguments};
    for (std::string flag, value; words >> flag >> value;) {
        constexpr std::string_view sourceMark = "{source}";
        const std::size_t at = value.find(sourceMark);
        if (at != std::string::npos) value.replace(at, sourceMark.size(), source.string());
        if (flag == "--preset")
            setPreset(settings, value, flag);
        else
            set(settings, flag.substr(2), value, flag);
    }
    return settings;
}

SheetSettings sheetFrom(const std::string& arguments) {
    SheetSettings settings;
    std::istringstream words{arguments};
    for (std::string flag, value; words >> flag >> value;)
        std::ranges::find(sheetOptions(), flag.substr(2), &SheetOption::name)->set(settings, value);
    return settings;
}

std::vector<Case> readCases() {
    std::ifstream stream{source / "tests/images/cases.json"};
    const auto file = nlohmann::json::parse(stream);
    std::vector<Case> cases;
    for (const auto& entry : file.at("cases")) {
        const auto& tolerance = file.at("tolerances").at(entry.at("tolerance").get<std::string>());
        Case c{.name = entry.at("name"),
               .asset = source / "assets" / entry.at("asset").get<std::string>(),
               .settings = settingsFrom(entry.at("arguments")),
               .map = {},
               .sheet = {},
               .tolerance = {tolerance.at("level"), tolerance.at("share"), tolerance.at("hard_limit")}};
        if (entry.contains("sheet")) c.sheet = sheetFrom(entry.at("sheet"));
        if (entry.contains("map")) {
            set(c.settings, "maps", entry.at("map").get<std::string>(), "map");
            c.map = c.settings.maps.front();
        }
        cases.push_back(std::move(c));
    }
    return cases;
}

void draw(const Case& c, Renderer& renderer, const fs::path& candidate) {
    const Scene scene = loadScene(c.asset, loadSettings(c.settings));
    if (c.sheet) return writeSheet(drawSheet(renderer, scene, c.settings, *c.sheet), candidate);
    const Camera camera = frameCamera(scene, c.settings.camera, c.settings.picture.size);
    const Maps maps = renderer.render(scene, camera, c.settings);
    if (!c.map) {
        writeMaps(maps, {}, candidate);
        return;
    }
    const auto files = writeMaps(maps, c.settings.maps, candidate);  // the picture, then the map
    fs::rename(files.at(1), candidate);
}

class Picture : public testing::TestWithParam<std::tuple<Case, const char*>> {
protected:
    static std::string backendName() { return std::get<1>(GetParam()); }

    // One renderer a backend for all cases: a case must not depend on those before it. None outlives the suite, because
    // OSMesa cannot end a context once the program's exit handlers run.
    static void TearDownTestSuite() { renderers_.clear(); }

    static Renderer* renderer() {
        const std::string backend = backendName();
        if (!renderers_.contains(backend)) {
            try {
                Settings settings;
                set(settings, "backend", backend, "this test");
                renderers_[backend] = std::make_unique<Renderer>(settings.backend);
            } catch (const Error& error) {
                renderers_[backend] = nullptr;
                if (error.kind() != Error::Kind::Context) throw;
            }
        }
        return renderers_[backend].get();
    }

private:
    static inline std::map<std::string, std::unique_ptr<Renderer>> renderers_;  // null: does not work here
};

TEST_P(Picture, IsAsItsReference) {
    if (renderer() == nullptr) GTEST_SKIP() << backendName() << " does not work here";
    const Case& c = std::get<0>(GetParam());
    const fs::path folder = fs::path{INKEDGE_IMAGE_FOLDER} / backendName();
    const fs::path candidate = folder / (c.name + ".png");
    const fs::path difference = folder / (c.name + ".difference.png");
    const fs::path reference = source / "reference_images" / (c.name + ".png");
    fs::create_directories(folder);
    fs::remove(difference);

    draw(c, *renderer(), candidate);
    ASSERT_TRUE(fs::exists(reference)) << "there is no reference yet; look at " << candidate.string()
                                       << " and, if it is right: tools/accept_reference " << c.name;
    const Comparison comparison = compare(candidate, reference, c.tolerance, difference);
    RecordProperty("pixels_over_level", std::to_string(comparison.pixelsOverLevel));
    if (comparison.same) fs::remove(difference);
    EXPECT_TRUE(comparison.same) << fmt::format(
        "{} of {} pixels differ by more than {}, {} are allowed; the largest difference is {:.3f} at {},{}\n"
        "  candidate  {}\n  reference  {}\n  difference {}\nif the candidate is right: tools/accept_reference {}",
        comparison.pixelsOverLevel, comparison.size.width * comparison.size.height, c.tolerance.level,
        static_cast<int>(c.tolerance.share * comparison.size.width * comparison.size.height), comparison.maximum,
        comparison.maximumX, comparison.maximumY, candidate.string(), reference.string(), difference.string(), c.name);
}

INSTANTIATE_TEST_SUITE_P(Cases, Picture,
                         testing::Combine(testing::ValuesIn(readCases()), testing::Values("egl", "osmesa")),
                         [](const auto& test) { return std::get<0>(test.param).name + '_' + std::get<1>(test.param); });

TEST(References, EachBelongsToACase) {
    std::set<std::string> known;
    for (const Case& c : readCases()) known.insert(c.name);
    std::ifstream stream{source / "tests/images/cases.json"};
    const auto file = nlohmann::json::parse(stream);
    for (const auto& name : file.at("other pictures")) {
        known.insert(name.get<std::string>());  // made by tools/update_readme
    }
    for (const auto& entry : fs::directory_iterator{source / "reference_images"}) {
        EXPECT_TRUE(known.contains(entry.path().stem().string())) << entry.path();
    }
}

TEST(References, CoverEveryAsset) {
    const std::vector<Case> cases = readCases();
    for (const auto& entry : fs::directory_iterator{source / "assets"}) {
        if (entry.path().extension() != ".glb") continue;
        EXPECT_NE(std::ranges::find(cases, entry.path(), &Case::asset), cases.end()) << entry.path();
    }
}

}  // namespace
}  // namespace inkedge
