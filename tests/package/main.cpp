// draw MODEL OUT.png OUT.exr OUT.svg: draws a model with the installed library; exit status 0 if the picture has lines
// and lines are found.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <inkedge/inkedge.h>

namespace {

// Fewer or more black pixels than this are no outline drawing of a model that fills the picture.
constexpr double minLines = 0.002;
constexpr double maxLines = 0.5;

bool hasLines(const inkedge::Image<std::uint8_t>& picture) {
    const auto black = std::count(picture.pixels().begin(), picture.pixels().end(), std::uint8_t{0});
    const double share = static_cast<double>(black) / static_cast<double>(picture.pixels().size());
    std::printf("%td of %zu pixels are black\n", black, picture.pixels().size());
    return share > minLines && share < maxLines;
}

// The same model from memory gives the same picture, and a mesh given by arrays has lines.
void drawFromMemory(const char* model, inkedge::Renderer& renderer, const inkedge::Settings& settings) {
    std::ifstream stream{model, std::ios::binary};
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>{stream}, {}};
    const inkedge::Scene file = inkedge::loadScene(model);
    const inkedge::Scene memory = inkedge::loadScene(bytes, "model.glb");
    const inkedge::Camera camera = inkedge::frameCamera(file, settings.camera, settings.picture.size);
    if (renderer.render(file, camera, settings).picture.pixels() !=
        renderer.render(memory, camera, settings).picture.pixels())
        throw std::runtime_error{"expected a model in memory to give its file's picture, found another"};
    if (inkedge::readableFormats().empty()) throw std::runtime_error{"expected formats that are read, found none"};

    const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<std::uint16_t> triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    inkedge::InstancedArrays arrays;
    arrays.mesh.positions = {corners.data(), inkedge::NumberType::Float32, 4, 3};
    arrays.mesh.indices = {triangles.data(), inkedge::NumberType::UInt16, 4, 3};
    const inkedge::Scene tetrahedron = inkedge::makeScene({&arrays, 1}, inkedge::loadSettings(settings));
    const inkedge::Maps maps = renderer.render(
        tetrahedron, inkedge::frameCamera(tetrahedron, settings.camera, settings.picture.size), settings);
    if (!hasLines(maps.picture) || !maps.warnings.empty())
        throw std::runtime_error{"expected a tetrahedron's lines and no warnings, found otherwise"};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "expected MODEL OUT.png OUT.exr OUT.svg, found %d arguments\n", argc - 1);
        return 2;
    }
    if (inkedge::version() != EXPECTED_VERSION) {
        std::fprintf(stderr, "expected version %s, found %s\n", EXPECTED_VERSION, inkedge::version().data());
        return 1;
    }
    try {
        inkedge::Settings settings;
        settings.picture.size = {256, 256};
        inkedge::set(settings, "detector", "classic", "this test");
        settings.maps = {inkedge::Map::Depth, inkedge::Map::Normal};

        const inkedge::Scene scene = inkedge::loadScene(argv[1]);
        const inkedge::Camera camera = inkedge::frameCamera(scene, settings.camera, settings.picture.size);
        inkedge::Renderer renderer;
        const inkedge::Maps maps = renderer.render(scene, camera, settings);

        inkedge::writeMaps(maps, {}, argv[2]);

        inkedge::Settings colored = settings;
        colored.detector.functions = {inkedge::surfaceFunction("base-color")};
        bool refused = false;
        try {
            (void)renderer.render(scene, camera, colored);
        } catch (const inkedge::Error& error) {
            refused = error.kind() == inkedge::Error::Kind::Usage;
        }
        if (!refused) throw std::runtime_error{"expected a scene without colours to be refused, found it drawn"};
        (void)renderer.render(inkedge::loadScene(argv[1], inkedge::loadSettings(colored)), camera, colored);
        inkedge::writeMaps(maps, settings.maps, argv[3]);

        drawFromMemory(argv[1], renderer, settings);

        settings.detector.detector = inkedge::Detector::Planes;
        settings.lines.from = inkedge::LinesFrom::Image;  // needs no Embree
        const inkedge::Lines lines = renderer.lines(scene, camera, settings);
        inkedge::writeLines(lines, settings, argv[4]);
        std::printf("%zu lines\n", lines.lines.size());
        if (lines.lines.empty()) return 1;
        return hasLines(maps.picture) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
