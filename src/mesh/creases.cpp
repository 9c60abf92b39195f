#include "mesh/creases.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/parallel.h"
#include "mesh/authored_normals.h"
#include "mesh/bends.h"
#include "mesh/facets.h"
#include "mesh/follow_creases.h"

namespace inkedge::mesh {
namespace {

constexpr double minSplitBend = 9.0;       // degrees
constexpr double maxExcess = 15.0;         // degrees that normals may be split by more than the faces bend
constexpr double minSplitShare = 1.0 / 3;  // of the bend, that normals are split by

// Degrees within which an edge is in doubt: what facets of one kind differ by. By bends alone, as asked for, only what
// rounding of coordinates makes of them.
constexpr double doubt = 1.0;
constexpr double rounding = 0.1;

// A surface of many faces that bend by this, in degrees, at half of their edges is rough: a scan, most likely.
constexpr double minRoughness = 3.0;
constexpr std::size_t minRoughFaces = 1000;
// On it, edges that bend by this share of their angle carry creases on, and creases of fewer edges are none.
constexpr double weakShare = 0.6;
constexpr std::uint32_t minChain = 6;

enum class Evidence { Smooth, Doubt, Crease };

// An edge that bends by more than an angle; near the angle it must carry on another.
class Threshold {
public:
    // @param max  degrees to either side that are in doubt, at most
    Threshold(double degrees, double max) {
        const double margin = std::min(max, 0.1 * degrees);
        // No edge bends by more than 180 degrees: at that angle none is a crease.
        beyond_ = degrees + margin > 180.0 ? -2.0 : std::cos(glm::radians(degrees + margin));
        within_ = degrees >= 180.0 ? -2.0 : std::cos(glm::radians(degrees - margin));
    }
    [[nodiscard]] Evidence of(double bendCosine) const {
        return bendCosine < beyond_ ? Evidence::Crease : bendCosine < within_ ? Evidence::Doubt : Evidence::Smooth;
    }

private:
    double beyond_;
    double within_;
};

enum class Normal { Unknown, Shared, SplitAtOneEnd, Split };

class Edges {
public:
    Edges(const Mesh& mesh, const MeshTopology& topology, const std::vector<bool>& disbelieved)
        : mesh_{mesh}, topology_{topology}, disbelieved_{disbelieved} {}

    // What the file's normals on both sides say of an edge that bends by a given cosine.
    [[nodiscard]] Normal normalsAt(std::uint32_t h, std::uint32_t twin, double bendCosine) const {
        if (!disbelieved_.empty() && (disbelieved_[h / 3] || disbelieved_[twin / 3])) return Normal::Unknown;
        const TwinEnds ends = endsOfTwin(topology_, h, twin);
        const double start = cosine(h, ends.atStart, h, twin);
        const double end = cosine(nextHalfEdge(h), ends.atEnd, h, twin);
        if (start == missing || end == missing) return Normal::Unknown;
        const bool splitAtStart = start < sharedCosine_;
        const bool splitAtEnd = end < sharedCosine_;
        if (!splitAtStart && !splitAtEnd) return Normal::Shared;
        const double bend = std::acos(std::clamp(bendCosine, -1.0, 1.0));
        const auto agrees = [&](double splitCosine) {
            const double split = std::acos(std::clamp(splitCosine, -1.0, 1.0));
            return split <= bend + glm::radians(maxExcess) && split >= minSplitShare * bend;
        };
        if ((splitAtStart && !agrees(start)) || (splitAtEnd && !agrees(end))) return Normal::Unknown;
        return splitAtStart && splitAtEnd ? Normal::Split : Normal::SplitAtOneEnd;
    }

private:
    static constexpr double missing = 2.0;

    [[nodiscard]] double cosine(std::uint32_t a, std::uint32_t b, std::uint32_t h, std::uint32_t twin) const {
        const std::uint32_t i = mesh_.indices[a];
        const std::uint32_t j = mesh_.indices[b];
        const glm::dvec3 m{mesh_.normals[i]};
        const glm::dvec3 n{mesh_.normals[j]};
        const double lengths = std::sqrt(glm::dot(m, m) * glm::dot(n, n));
        if (lengths == 0.0) return missing;
        // Normals of faces wound against each other may point to opposite sides of one surface.
        const bool against = topology_.points[h] == topology_.points[twin];
        return i == j && !against ? 1.0 : (against ? -1.0 : 1.0) * glm::dot(m, n) / lengths;
    }

    const Mesh& mesh_;
    const MeshTopology& topology_;
    const std::vector<bool>& disbelieved_;
    double sharedCosine_ = std::cos(sameNormal);
};

class Finder {
public:
    Finder(const Mesh& mesh, const std::vector<bool>& disbelieved, const LoadSettings& settings, MeshTopology& topology)
        : mesh_{mesh},
          topology_{topology},
          edges_{mesh, topology, disbelieved},
          kind_{settings.creases},
          byBend_{settings.creaseAngle, settings.creases == Creases::Angle ? rounding : doubt},
          shared_{sharedCreaseAngle(settings), doubt},
          split_{std::min(minSplitBend, settings.creaseAngle), doubt},
          weakByBend_{weakShare * settings.creaseAngle, 0.0},
          weakShared_{weakShare * sharedCreaseAngle(settings), 0.0},
          rough_{settings.creases == Creases::Auto && topology.originals.size() >= minRoughFaces &&
                 medianBend(mesh, topology) >= minRoughness} {}

    void find() {
        topology_.creases.assign(topology_.twins.size(), false);
        const std::vector<Found> parts = base::partsOf(topology_.twins.size(), [&](std::size_t begin, std::size_t end) {
            return findIn(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
        });
        for (const Found& part : parts) {
            for (const std::uint32_t h : part.creases) take(h, Evidence::Crease);
            append(part.doubtful, found_.doubtful);
            append(part.splitLess, found_.splitLess);
            append(part.splitLessAtOneEnd, found_.splitLessAtOneEnd);
            append(part.sharedLess, found_.sharedLess);
            append(part.weak, found_.weak);
        }
        if (!found_.splitLess.empty() || !found_.splitLessAtOneEnd.empty()) takeSplit();
        followCreases(mesh_, found_.doubtful, topology_);
        if (!rough_) return;
        extendCreases(mesh_, found_.weak, topology_);
        dropShortChains(mesh_, minChain, topology_);
    }

private:
    using HalfEdges = std::vector<std::uint32_t>;

    struct Found {
        HalfEdges creases;
        HalfEdges doubtful;
        // Those of Creases::Auto whose faces bend by less than the crease angle, by the normals.
        HalfEdges splitLess;
        HalfEdges splitLessAtOneEnd;
        HalfEdges sharedLess;
        HalfEdges weak;  // of rough surfaces: carry on what is beyond doubt
    };

    static void append(const HalfEdges& from, HalfEdges& to) { to.insert(to.end(), from.begin(), from.end()); }

    // Of the edges whose first half-edge is in a range.
    [[nodiscard]] Found findIn(std::uint32_t begin, std::uint32_t end) const {
        Found found;
        for (std::uint32_t h = begin; h < end; ++h) {
            const std::uint32_t twin = topology_.twins[h];
            if (!isHalfEdge(twin) || twin < h || isSmoothByKind(mesh_, h, twin)) continue;
            if (!hasNormal(topology_, h / 3) || !hasNormal(topology_, twin / 3)) continue;
            const bool sharp = isOfKind(mesh_, h, twin, EdgeKind::Sharp);
            const Evidence crease = sharp ? Evidence::Crease : evidence(h, twin, found);
            if (crease == Evidence::Crease) found.creases.push_back(h);
            if (crease == Evidence::Doubt) found.doubtful.push_back(h);
        }
        return found;
    }

    void take(std::uint32_t h, Evidence evidence) {
        if (evidence == Evidence::Doubt) found_.doubtful.push_back(h);
        if (evidence == Evidence::Crease) topology_.creases[h] = topology_.creases[topology_.twins[h]] = true;
    }

    Evidence evidence(std::uint32_t h, std::uint32_t twin, Found& found) const {
        const double bend = bendCosine(topology_, h, twin);
        const Evidence byBend = byBend_.of(bend);
        if (kind_ == Creases::Angle) return byBend;
        if (kind_ == Creases::Normals) return byNormals(edges_.normalsAt(h, twin, bend), byBend);
        const Evidence ifSplit = split_.of(bend);
        if (ifSplit == Evidence::Smooth) return Evidence::Smooth;
        switch (edges_.normalsAt(h, twin, bend)) {
            case Normal::Unknown:
                if (rough_ && weakByBend_.of(bend) == Evidence::Crease) found.weak.push_back(h);
                return byBend;
            case Normal::Shared:
                if (byBend == Evidence::Smooth) found.sharedLess.push_back(h);
                if (rough_ && weakShared_.of(bend) == Evidence::Crease) found.weak.push_back(h);
                return shared_.of(bend);
            case Normal::SplitAtOneEnd:
                if (byBend != Evidence::Crease) found.splitLessAtOneEnd.push_back(h);
                return byBend != Evidence::Crease ? Evidence::Smooth : std::max(Evidence::Doubt, shared_.of(bend));
            case Normal::Split:
                break;
        }
        if (byBend == Evidence::Crease) return Evidence::Crease;
        found.splitLess.push_back(h);
        return Evidence::Smooth;  // until takeSplit()
    }

    static Evidence byNormals(Normal normals, Evidence byBend) {
        switch (normals) {
            case Normal::Shared:
                return Evidence::Smooth;
            case Normal::SplitAtOneEnd:
                return Evidence::Doubt;
            case Normal::Split:
                return Evidence::Crease;
            case Normal::Unknown:
                break;
        }
        return byBend;
    }

    // Decides on the edges with split normals that bend by less than the crease angle.
    void takeSplit() {
        const Facets facets{mesh_, topology_, {found_.splitLess, found_.sharedLess}};
        HalfEdges chosen;
        const auto takeAll = [&](const HalfEdges& halfEdges, Evidence max) {
            for (const std::uint32_t h : halfEdges) {
                const double bend = bendCosine(topology_, h, topology_.twins[h]);
                const Evidence found = facets.contain(h / 3) ? byBend_.of(bend) : split_.of(bend);
                if (std::min(found, max) == Evidence::Crease) chosen.push_back(h);
                if (std::min(found, max) == Evidence::Doubt) found_.doubtful.push_back(h);
            }
        };
        takeAll(found_.splitLess, Evidence::Crease);
        takeAll(found_.splitLessAtOneEnd, Evidence::Doubt);
        const std::vector<bool> alone = standAlone(topology_, chosen);
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (!alone[i]) take(chosen[i], Evidence::Crease);
    }

    const Mesh& mesh_;
    MeshTopology& topology_;
    Edges edges_;
    Creases kind_;
    Threshold byBend_;
    Threshold shared_;
    Threshold split_;
    Threshold weakByBend_;
    Threshold weakShared_;
    bool rough_;
    Found found_;
};

}  // namespace

double sharedCreaseAngle(const LoadSettings& settings) {
    switch (settings.creases) {
        case Creases::Angle:
            return settings.creaseAngle;
        case Creases::Normals:
            return 180.0;
        case Creases::Auto:
            break;
    }
    return std::min(180.0, 2.0 * settings.creaseAngle);
}

void findCreases(const Mesh& mesh, const std::vector<bool>& disbelieved, const LoadSettings& settings,
                 MeshTopology& topology) {
    Finder{mesh, disbelieved, settings, topology}.find();
}

}  // namespace inkedge::mesh
