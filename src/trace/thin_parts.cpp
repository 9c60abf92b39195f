#include "trace/thin_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/stop.h"
#include "mesh/topology.h"
#include "scene/prepared.h"
#include "trace/cell_lists.h"

namespace inkedge::trace {
namespace {

constexpr double coarseStep = 4.0;  // pixels of contour between two looks for thin parts

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// The stretches found so far, by the pixels that their middles lie in.
class StretchGrid {
public:
    explicit StretchGrid(double pixel) : pixel_{pixel} {}

    // Adds a stretch unless it was found before, from the opposite contour or from one behind it or before it: of two
    // contours that fall on each other the nearer one stays.
    void add(const ThinStretch& stretch) {
        const glm::dvec2 at = middle(stretch);
        const Cell cell = cellOf(at, 1.0 / pixel_);
        const bool known = cells_.anyAround(cell, [&](std::uint32_t i) {
            ThinStretch& other = found_[i];
            const double cosine = glm::dot(other.across, stretch.across);
            if (cosine < -0.5 && distance(at, other) < 0.5 * pixel_) return true;
            if (cosine < 0.5 || glm::distance(at, middle(other)) > sameSpot * pixel_) return false;
            if (stretch.plane.w > other.plane.w) other = stretch;
            return true;
        });
        if (known) return;
        found_.push_back(stretch);
        cells_.add(cell);
    }

    std::vector<ThinStretch> take() { return std::move(found_); }

private:
    static constexpr double sameSpot = 0.05;  // pixels

    static glm::dvec2 middle(const ThinStretch& s) { return 0.5 * (s.ends[0] + s.ends[1]); }

    static double distance(glm::dvec2 p, const ThinStretch& s) {
        const glm::dvec2 along = s.ends[1] - s.ends[0];
        const double squared = glm::dot(along, along);
        const double t = squared > 0.0 ? std::clamp(glm::dot(p - s.ends[0], along) / squared, 0.0, 1.0) : 0.0;
        return glm::distance(p, s.ends[0] + t * along);
    }

    double pixel_;
    std::vector<ThinStretch> found_;
    CellLists cells_;  // of their middles, as they were added
};

// Which ways the contours of one instance face, pixel by pixel: a part is thin only where two contours that do not face
// the same way are near each other, and a look here costs far less than a walk.
class ContourMap {
public:
    ContourMap(Size samples, double pixel)
        : pixel_{pixel},
          facing_{{static_cast<int>(samples.width / pixel) + 1, static_cast<int>(samples.height / pixel) + 1}, 1} {}

    void clear() {
        for (std::uint8_t* const at : marked_) *at = 0;
        marked_.clear();
    }

    // Marks the pixels along a line, at steps of half a pixel.
    void mark(glm::dvec2 from, glm::dvec2 to, glm::dvec2 across) {
        const auto octant = static_cast<std::uint8_t>(1U << octantOf(across));
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / (0.5 * pixel_))));
        for (int i = 0; i < steps; ++i) {
            const auto [x, y] = cellOf(glm::mix(from, to, (i + 0.5) / steps), 1.0 / pixel_);
            if (x < 0 || y < 0 || x >= facing_.size().width || y >= facing_.size().height) continue;
            std::uint8_t& at = facing_(x, y);
            if (at == 0) marked_.push_back(&at);
            at |= octant;
        }
    }

    // Whether a contour within a pixel of a point may be the opposite one.
    [[nodiscard]] bool mayHaveOpposite(glm::dvec2 p, glm::dvec2 across) const {
        constexpr int reach = 2;                  // contours are marked at steps of half a pixel
        constexpr unsigned others = 0b0111'1100;  // octants two or more away, counted from the own one
        const unsigned octant = octantOf(across);
        const unsigned mask = ((others << octant) | (others >> (8U - octant))) & 0xFFU;
        const auto [x, y] = cellOf(p, 1.0 / pixel_);
        const auto [width, height] = facing_.size();
        for (int v = std::max(y - reach, 0); v <= std::min(y + reach, height - 1); ++v)
            for (int u = std::max(x - reach, 0); u <= std::min(x + reach, width - 1); ++u)
                if ((facing_(u, v) & mask) != 0) return true;
        return false;
    }

private:
    // 0 to 7, around.
    static unsigned octantOf(glm::dvec2 d) {
        const bool flat = std::abs(d.x) > std::abs(d.y);
        if (d.y >= 0.0) return d.x >= 0.0 ? (flat ? 0 : 1) : (flat ? 3 : 2);
        return d.x < 0.0 ? (flat ? 4 : 5) : (flat ? 7 : 6);
    }

    double pixel_;
    Image<std::uint8_t> facing_;
    std::vector<std::uint8_t*> marked_;
};

class ThinPartFinder {
public:
    ThinPartFinder(const Scene& scene, const ScreenTriangles& triangles, Size samples, int samplesPerPixel)
        : scene_{scene},
          triangles_{triangles},
          samples_{samples},
          pixel_{static_cast<double>(samplesPerPixel)},
          grid_{pixel_},
          map_{samples, pixel_} {}

    std::vector<ThinStretch> find() {
        for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) {
            base::stopIfAsked();
            findIn(i);
        }
        return grid_.take();
    }

private:
    // A face at an edge.
    struct Beside {
        scene::SceneFace face;
        glm::dvec2 third;  // corner
    };
    struct Faces {
        Beside all[2];
        int count = 0;
        void add(const Beside& face) { all[count++] = face; }
    };

    struct Contour {
        glm::dvec2 ends[2];
        glm::dvec2 across;  // unit, towards the surface
        Faces faces;
        bool isBorder;
    };
    // The surface's far side, seen from a point of a contour.
    struct Opposite {
        double thickness;
        bool isBorder;
    };

    void findIn(std::uint32_t instance) {
        collectContours(instance);
        for (const Contour& contour : contours_) {
            const auto [from, to] = shownPart(contour);
            map_.mark(glm::mix(contour.ends[0], contour.ends[1], from), glm::mix(contour.ends[0], contour.ends[1], to),
                      contour.across);
        }
        for (const Contour& contour : contours_) follow(contour);
        findGaps();
        contours_.clear();
        map_.clear();
    }

    void findGaps() {
        if (std::ranges::none_of(contours_, &Contour::isBorder)) return;
        BorderSpots spots{1.0 / (maxGap * pixel_)};
        for (std::uint32_t i = 0; i < contours_.size(); ++i) {
            const Contour& contour = contours_[i];
            if (!contour.isBorder) continue;
            const auto [from, to] = shownPart(contour);
            const glm::dvec2 begin = glm::mix(contour.ends[0], contour.ends[1], from);
            const glm::dvec2 end = glm::mix(contour.ends[0], contour.ends[1], to);
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(begin, end) / (0.5 * pixel_))));
            if (!mayLook(static_cast<std::uint64_t>(steps))) return;
            for (int k = 0; k <= steps; ++k) spots.add(i, glm::mix(begin, end, static_cast<double>(k) / steps));
        }
        for (const Contour& contour : contours_)
            if (contour.isBorder) followGap(contour, spots);
    }

    // Where very many borders lie over each other the search ends early, and some gaps are missed.
    [[nodiscard]] bool mayLook(std::uint64_t times = 1) {
        if (looksLeft_ < times)
            looksLeft_ = 0;
        else
            looksLeft_ -= times;
        return looksLeft_ > 0;
    }

    // Borders by the cells that they pass through.
    struct BorderSpots {
        double perSide;  // 1 / the side of a cell
        CellLists cells;
        std::vector<std::uint32_t> contours;
        explicit BorderSpots(double perSide_) : perSide{perSide_} {}
        void add(std::uint32_t contour, glm::dvec2 at) {
            cells.add(cellOf(at, perSide));
            contours.push_back(contour);
        }
    };

    void followGap(const Contour& contour, const BorderSpots& spots) {
        const auto [from, to] = shownPart(contour);
        const double length = glm::distance(contour.ends[0], contour.ends[1]);
        const int count = std::max(1, static_cast<int>(std::ceil((to - from) * length / pixel_)));
        std::optional<Facing> facing;
        std::optional<double> before = gapAt(contour, from, spots);
        for (int i = 0; i < count; ++i) {
            const double begin = from + i * (to - from) / count;
            const double end = from + (i + 1) * (to - from) / count;
            const std::optional<double> after = gapAt(contour, end, spots);
            if (before && after) {
                if (!facing) facing = facingOf(contour);
                const auto at = [&](double share) { return glm::mix(contour.ends[0], contour.ends[1], share); };
                grid_.add({{at(begin) - 0.5 * *before * contour.across, at(end) - 0.5 * *after * contour.across},
                           -contour.across,
                           {*before, *after},
                           facing->face,
                           {facing->w(at(0.5 * (begin + end))), facing->plane.x, facing->plane.y},
                           true,
                           true});
            }
            before = after;
        }
    }

    // How far it is from a border, away from the surface, to the next one that faces it: minGap to maxGap.
    [[nodiscard]] std::optional<double> gapAt(const Contour& contour, double share, const BorderSpots& spots) {
        constexpr double inset = 1e-3;  // corners belong to two edges
        const glm::dvec2 from = glm::mix(contour.ends[0], contour.ends[1], std::clamp(share, inset, 1.0 - inset));
        if (!mayLook() || !map_.mayHaveOpposite(from, contour.across)) return {};
        double nearest = std::numeric_limits<double>::infinity();
        spots.cells.anyAround(cellOf(from, spots.perSide), [&](std::uint32_t spot) {
            if (!mayLook()) return true;
            const Contour& other = contours_[spots.contours[spot]];
            if (glm::dot(other.across, contour.across) > -0.5) return false;
            const glm::dvec2 along = other.ends[1] - other.ends[0];
            const double scale = cross(contour.across, along);
            const double t = -cross(other.ends[0] - from, along) / scale;
            const double u = cross(other.ends[0] - from, contour.across) / scale;
            if (u >= 0.0 && u <= 1.0 && t >= 0.0) nearest = std::min(nearest, t);
            return false;
        });
        if (!(nearest >= minGap * pixel_ && nearest <= maxGap * pixel_)) return {};
        return nearest;
    }

    void collectContours(std::uint32_t instance) {
        const std::uint32_t meshIndex = scene_.instances()[instance].mesh;
        const Mesh& mesh = scene_.meshes()[meshIndex];
        const std::vector<glm::dvec2> pixels = pixelsOf(instance, mesh.positions.size());
        const auto at = [&](std::uint32_t corner) { return pixels[mesh.indices[corner]]; };
        std::vector<std::int8_t> turns(mesh.indices.size() / 3);
        base::inRanges(turns.size(), [&](std::size_t begin, std::size_t end) {
            for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
                turns[t] = turnOf(at(3 * t), at(3 * t + 1), at(3 * t + 2));
        });
        for (const std::vector<Contour>&part :
             base::partsOf(mesh.indices.size(), [&](std::size_t begin, std::size_t end) {
                 return contoursIn(instance, pixels, turns, static_cast<std::uint32_t>(begin), end);
             }))
            contours_.insert(contours_.end(), part.begin(), part.end());
    }

    // Those of the edges whose first half-edge is in a range.
    [[nodiscard]] std::vector<Contour> contoursIn(std::uint32_t instance, const std::vector<glm::dvec2>& pixels,
                                                  const std::vector<std::int8_t>& turns, std::uint32_t first,
                                                  std::size_t last) const {
        const std::uint32_t meshIndex = scene_.instances()[instance].mesh;
        const mesh::MeshTopology& topology = scene::topologyOf(scene_, meshIndex);
        const Mesh& mesh = scene_.meshes()[meshIndex];
        const auto at = [&](std::uint32_t corner) { return pixels[mesh.indices[corner]]; };
        const auto isBehindEye = [&](std::uint32_t corner) { return std::isnan(at(corner).x); };
        std::vector<Contour> contours;
        for (std::uint32_t h = first; h < last; ++h) {
            const std::uint32_t twin = topology.twins[h];
            const bool isBorder = twin == mesh::noHalfEdge && topology.originals[h / 3] == h / 3;
            // Folds are few: asked for first, they can be foreseen, unlike which half-edge of two is the first.
            if (!isBorder &&
                (!mesh::isHalfEdge(twin) ||
                 !isFold(turns[h / 3], turns[twin / 3], topology.points[h] == topology.points[twin]) || twin < h))
                continue;
            const std::uint32_t end = mesh::nextHalfEdge(h);
            if (isBehindEye(h) || isBehindEye(end)) continue;
            Faces faces;
            for (const std::uint32_t half : {h, twin}) {
                if (!mesh::isHalfEdge(half) || turns[half / 3] == edgeOn) continue;
                const std::uint32_t third = mesh::previousHalfEdge(half);
                if (!isBehindEye(third)) faces.add({{instance, half / 3}, at(third)});
            }
            if (const auto contour = contourOf({at(h), at(end)}, faces, isBorder)) contours.push_back(*contour);
        }
        return contours;
    }

    [[nodiscard]] std::vector<glm::dvec2> pixelsOf(std::uint32_t instance, std::size_t positions) const {
        std::vector<glm::dvec2> pixels(positions);
        base::inRanges(positions, [&](std::size_t begin, std::size_t end) {
            for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
                const glm::dvec3 point = triangles_.projected(instance, p);
                pixels[p] = point.z > 0.0 ? glm::dvec2{point} / point.z : glm::dvec2{behindEye};
            }
        });
        return pixels;
    }

    static constexpr std::int8_t edgeOn = 0;
    static constexpr double behindEye = std::numeric_limits<double>::quiet_NaN();

    // Which way a triangle is turned in the picture.
    [[nodiscard]] std::int8_t turnOf(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) const {
        constexpr double minHeight = 1e-3;  // pixels: coordinates are not known better
        const double area = cross(b - a, c - a);
        const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
        if (!(area * area > minHeight * minHeight * pixel_ * pixel_ * longest)) return edgeOn;
        return area > 0.0 ? 1 : -1;
    }

    // Whether the surface turns back at the edge between two triangles.
    [[nodiscard]] static bool isFold(std::int8_t a, std::int8_t b, bool woundAgainst) {
        const bool isFlat = a * b == 0;
        return (a == b) == (woundAgainst && !isFlat);
    }

    // The contour along an edge, if the picture may show it.
    [[nodiscard]] std::optional<Contour> contourOf(std::array<glm::dvec2, 2> ends, const Faces& faces,
                                                   bool isBorder) const {
        const auto [low, high] = std::pair{glm::min(ends[0], ends[1]), glm::max(ends[0], ends[1])};
        if (faces.count == 0 || high.x < 0.0 || high.y < 0.0 || low.x > samples_.width || low.y > samples_.height)
            return {};
        const glm::dvec2 along = ends[1] - ends[0];
        const double length = glm::length(along);
        if (!(length > 0.0)) return {};
        glm::dvec2 across = glm::dvec2{-along.y, along.x} / length;
        if (glm::dot(faces.all[0].third - ends[0], across) < 0.0) across = -across;
        return Contour{{ends[0], ends[1]}, across, faces, isBorder};
    }

    // A face and its plane, as a function of the picture.
    struct Facing {
        scene::SceneFace face;
        glm::dvec3 plane;
        [[nodiscard]] double w(glm::dvec2 at) const { return glm::dot(plane, glm::dvec3{at, 1.0}); }
    };

    // The face that is seen at a contour: the nearer one.
    [[nodiscard]] Facing facingOf(const Contour& contour) const {
        const auto facing = [&](const Beside& beside) {
            return Facing{beside.face, triangles_.planeFunction(beside.face)};
        };
        const Facing first = facing(contour.faces.all[0]);
        if (contour.faces.count == 1) return first;
        const Facing second = facing(contour.faces.all[1]);
        const glm::dvec2 inside = 0.5 * (contour.ends[0] + contour.ends[1]) + 0.01 * contour.across;
        return second.w(inside) > first.w(inside) ? second : first;
    }

    void follow(const Contour& contour) {
        const double length = glm::distance(contour.ends[0], contour.ends[1]);
        // What lies off the picture is not looked at.
        const auto [from, to] = shownPart(contour);
        const int looks = std::max(1, static_cast<int>(std::ceil((to - from) * length / (coarseStep * pixel_))));
        const double step = (to - from) / looks;
        std::optional<Facing> facing;
        for (int i = 0; i < looks; ++i) {
            const double begin = from + i * step;
            const double middle = begin + 0.5 * step;
            if (!map_.mayHaveOpposite(glm::mix(contour.ends[0], contour.ends[1], middle), contour.across)) continue;
            if (!facing) facing = facingOf(contour);
            if (const std::optional<Opposite> there = opposite(contour, facing->face, middle))
                addStretches(contour, *facing, *there, begin, begin + step, step * length);
        }
    }

    // The shares of a contour's length between which the picture shows it.
    [[nodiscard]] std::pair<double, double> shownPart(const Contour& contour) const {
        double from = 0.0;
        double to = 1.0;
        const double sizes[2]{static_cast<double>(samples_.width), static_cast<double>(samples_.height)};
        for (int axis = 0; axis < 2; ++axis) {
            const double a = contour.ends[0][axis];
            const double step = contour.ends[1][axis] - a;
            if (step == 0.0) continue;
            const double low = -a / step;
            const double high = (sizes[axis] - a) / step;
            from = std::max(from, std::min(low, high));
            to = std::min(to, std::max(low, high));
        }
        return {from, std::max(from, to)};
    }

    [[nodiscard]] std::optional<Opposite> opposite(const Contour& contour, scene::SceneFace face, double share) const {
        constexpr double inset = 1e-3;  // corners belong to two edges
        const glm::dvec2 start = glm::mix(contour.ends[0], contour.ends[1], std::clamp(share, inset, 1.0 - inset));
        const auto exit =
            triangles_.walk(face, start, start + pixel_ * contour.across, ScreenTriangles::Over::Surface).exit;
        if (!exit || exit->end == ScreenTriangles::End::Crease || !(exit->t > 0.0)) return {};
        return Opposite{exit->t * pixel_, exit->end == ScreenTriangles::End::Border};
    }

    // @param there  in the middle; on a short way it is the same at both ends
    void addStretches(const Contour& contour, const Facing& facing, const Opposite& there, double from, double to,
                      double length) {
        const int count = std::max(1, static_cast<int>(std::ceil(length / pixel_)));
        const auto oppositeAt = [&](double share) {
            return count == 1 ? std::optional{there} : opposite(contour, facing.face, share);
        };
        std::optional<Opposite> before = oppositeAt(from);
        for (int i = 0; i < count; ++i) {
            const double begin = from + i * (to - from) / count;
            const double end = from + (i + 1) * (to - from) / count;
            const std::optional<Opposite> after = oppositeAt(end);
            if (before && after) {
                const auto at = [&](double share) { return glm::mix(contour.ends[0], contour.ends[1], share); };
                const auto middle = [&](double share, const Opposite& side) {
                    return at(share) + 0.5 * side.thickness * contour.across;
                };
                const double w = facing.w(at(0.5 * (begin + end)));
                const ThinStretch stretch{
                    {middle(begin, *before), middle(end, *after)}, contour.across,
                    {before->thickness, after->thickness},         facing.face,
                    {w, facing.plane.x, facing.plane.y},           contour.isBorder || before->isBorder};
                grid_.add(stretch);
            }
            before = after;
        }
    }

    const Scene& scene_;
    const ScreenTriangles& triangles_;
    Size samples_;
    double pixel_;  // samples
    StretchGrid grid_;
    ContourMap map_;
    std::vector<Contour> contours_;        // of one instance
    std::uint64_t looksLeft_ = 5'000'000;  // for gaps: a fraction of a second
};

}  // namespace

std::vector<ThinStretch> findThinParts(const Scene& scene, const ScreenTriangles& triangles, Size samples,
                                       int samplesPerPixel) {
    return ThinPartFinder{scene, triangles, samples, samplesPerPixel}.find();
}

}  // namespace inkedge::trace
