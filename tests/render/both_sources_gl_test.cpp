// Lines from object space and from image space of the same random scenes: no line of the one lies further than two
// pixels from a line of the other.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "gl/gl_test.h"
#include "render/ink_of_lines.h"
#include "render/random_scenes.h"

namespace inkedge::render {
namespace {

using ink_of_lines::alone;
using ink_of_lines::Ink;
using ink_of_lines::inkOf;
using ink_of_lines::square;

INKEDGE_ON_EACH_BACKEND(BothSources);

constexpr double largestAlone = 1.0;  // pixels of line of one source alone: where a line ends

// Image space takes the nearest at each pixel. What touches a face from behind is as near as the face, and shows
// through it where rounding says so.
constexpr std::array<std::uint32_t, 2> shineThrough{106, 404};

// What image space cannot see: it looks at the middles of pixels.
class Unseen {
public:
    Unseen(const Scene& scene, const Camera& camera, const std::vector<Ink>& ink) : scene_{scene}, camera_{camera} {
        for (const Ink& dot : ink) cells_[cellOf(dot.pixel)].push_back(&dot);
    }

    [[nodiscard]] bool holds(const Ink& dot) const { return isOfASheetFromItsEdge(dot) || isOfAStrip(dot); }

private:
    static std::pair<int, int> cellOf(glm::dvec2 pixel) {
        return {static_cast<int>(std::floor(pixel.x)), static_cast<int>(std::floor(pixel.y))};
    }

    // Whether another line, or another part of the line, is less than a pixel off: what lies between them is a strip
    // that covers the middle of no pixel.
    [[nodiscard]] bool isOfAStrip(const Ink& dot) const {
        constexpr double narrow = 1.0;  // pixels
        const auto [x, y] = cellOf(dot.pixel);
        for (int right = -1; right <= 1; ++right) {
            for (int down = -1; down <= 1; ++down) {
                const auto cell = cells_.find({x + right, y + down});
                if (cell == cells_.end()) continue;
                for (const Ink* other : cell->second) {
                    const bool goesOn = other->line == dot.line && std::abs(other->way - dot.way) < 6.0 * narrow;
                    if (!goesOn && glm::distance(other->pixel, dot.pixel) < narrow) return true;
                }
            }
        }
        return false;
    }

    // Whether an open sheet covers no middle of a pixel near a dot of its own.
    [[nodiscard]] bool isOfASheetFromItsEdge(const Ink& dot) const {
        const Instance& instance = scene_.instances()[dot.object - 1];
        const Mesh& mesh = scene_.meshes()[instance.mesh];
        if (mesh.name != "quad") return false;
        const auto corner = [&](std::size_t i) {
            const glm::dvec3 p = glm::dvec3{mesh.positions[mesh.indices[i]]} + mesh.origin;
            return scenes::pixel(camera_, square, glm::dvec3{instance.transform * glm::dvec4{p, 1.0}});
        };
        const glm::dvec2 first = glm::floor(dot.pixel - ink_of_lines::apart) + 0.5;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            for (double y = first.y; y <= dot.pixel.y + ink_of_lines::apart; ++y) {
                for (double x = first.x; x <= dot.pixel.x + ink_of_lines::apart; ++x)
                    if (covers({corner(t), corner(t + 1), corner(t + 2)}, {x, y})) return false;
            }
        }
        return true;
    }

    static bool covers(const std::array<glm::dvec2, 3>& corners, glm::dvec2 pixel) {
        std::array<double, 3> sides{};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 along = corners[(i + 1) % 3] - corners[i];
            const glm::dvec2 to = pixel - corners[i];
            sides[i] = along.x * to.y - along.y * to.x;
        }
        const auto [low, high] = std::ranges::minmax(sides);
        return low > 0.0 || high < 0.0;
    }

    const Scene& scene_;
    const Camera& camera_;
    std::map<std::pair<int, int>, std::vector<const Ink*>> cells_;
};

std::uint32_t numberIn(const char* variable, std::uint32_t otherwise) {
    const char* const text = std::getenv(variable);
    return text != nullptr ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

std::string pathsOf(const Lines& lines, const char* color, double width) {
    std::string svg;
    for (const Line& line : lines.lines) {
        if (!line.visible) continue;
        svg += fmt::format("<path fill='none' stroke='{}' stroke-width='{}' d='M", color, width);
        for (const LinePoint& point : line.points) svg += fmt::format(" {:.2f},{:.2f}", point.pixel.x, point.pixel.y);
        svg += line.closed ? " Z'/>\n" : "'/>\n";
    }
    return svg;
}

// Both drawings over each other, image space wide and red.
void writePicture(const std::filesystem::path& file, const Lines& image, const Lines& object) {
    std::ofstream{file} << fmt::format(
                               "<svg xmlns='http://www.w3.org/2000/svg' width='1080' height='1080' "
                               "viewBox='0 0 {} {}'><rect width='100%' height='100%' fill='white'/>\n",
                               square.width, square.height)
                        << pathsOf(image, "#f88", 1.6) << pathsOf(object, "#00f", 0.4) << "</svg>\n";
}

// INKEDGE_FIRST_SCENE and INKEDGE_SCENES are seeds to draw instead; INKEDGE_SCENE_PICTURES is a folder for a drawing of
// each scene in which the sources differ.
TEST_P(BothSources, ofRandomScenesAgree) {
    const std::uint32_t first = numberIn("INKEDGE_FIRST_SCENE", 0);
    const std::uint32_t count = numberIn("INKEDGE_SCENES", 500);
    const char* const pictures = std::getenv("INKEDGE_SCENE_PICTURES");
    LoadSettings load;
    load.creases = Creases::Angle;  // leaves no short line out
    for (std::uint32_t seed = first; seed < first + count; ++seed) {
        const random_scenes::RandomScene random = random_scenes::randomScene(seed);
        const Scene scene = scenes::sceneOf(random.parts, load);
        const Camera camera = frameCamera(scene, random.view, square);
        const auto linesFrom = [&](LinesFrom from) {
            Settings settings;
            settings.picture.size = square;
            settings.lines.from = from;
            return renderer().lines(scene, camera, settings);
        };
        const Lines image = linesFrom(LinesFrom::Image);
        const Lines object = linesFrom(LinesFrom::Object);
        const std::vector<Ink> imageInk = inkOf(image);
        const std::vector<Ink> objectInk = inkOf(object);
        const double imageAlone = alone(imageInk, {&objectInk});
        const Unseen unseen{scene, camera, objectInk};
        std::vector<Ink> seen;
        std::ranges::copy_if(objectInk, std::back_inserter(seen), [&](const Ink& dot) { return !unseen.holds(dot); });
        const double objectAlone = alone(seen, {&imageInk});
        if (std::max(imageAlone, objectAlone) <= largestAlone) continue;
        if (pictures != nullptr)
            writePicture(std::filesystem::path{pictures} / fmt::format("{}.svg", seed), image, object);
        if (std::ranges::find(shineThrough, seed) != shineThrough.end() && objectAlone <= largestAlone) continue;
        ADD_FAILURE() << "seed " << seed << ": " << imageAlone << " px of image space alone, " << objectAlone
                      << " px of object space alone: " << random.text;
    }
}

}  // namespace
}  // namespace inkedge::render
