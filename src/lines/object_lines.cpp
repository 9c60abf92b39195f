#include "lines/object_lines.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/later.h"
#include "base/parallel.h"
#include "base/stage_clock.h"
#include "base/stop.h"
#include "camera/stands_outside.h"
#include "lines/bridge_gaps.h"
#include "lines/chains.h"
#include "lines/coincident.h"
#include "lines/find/contour_finders.h"
#include "lines/find/contours.h"
#include "lines/find/file_lines.h"
#include "lines/find/form_lines.h"
#include "lines/find/intersections.h"
#include "lines/find/isolines.h"
#include "lines/find/mesh_edges.h"
#include "lines/screen.h"
#include "lines/see/crossings.h"
#include "lines/see/ray_caster.h"
#include "lines/see/surface_components.h"
#include "lines/see/touching.h"
#include "lines/see/visible_parts.h"
#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

// A tree of triangles takes as long a triangle as simple work on so many elements.
constexpr std::size_t workOfTree = 20;
constexpr double outside = 0.5;  // pixels beyond a contour: a surface that is met there lies behind the contour

// The segments of one view, and how they are seen.
struct ViewSegments {
    const Scene& scene;
    const RayCaster& rays;
    const Screen& screen;
    const SurfaceComponents* components;  // null: the scene is one component
    const Touching& touching;
    std::vector<Segment> segments;
    std::vector<ScreenSegment> projected;

    [[nodiscard]] glm::dvec3 pointAt(std::uint32_t s, double at) const {
        const ScreenSegment& p = projected[s];
        const double t = screen.unproject(at, p.ends[0].inverseDepth, p.ends[1].inverseDepth);
        return p.world[0] + t * (p.world[1] - p.world[0]);
    }

    // The direction across a segment in the picture, away from the surface that ends there.
    [[nodiscard]] glm::dvec2 outward(std::uint32_t s) const {
        const ScreenSegment& p = projected[s];
        const glm::dvec2 along = p.ends[1].pixel - p.ends[0].pixel;
        const double length = glm::length(along);
        if (length == 0.0) return {0.0, 0.0};
        const glm::dvec2 normal{-along.y / length, along.x / length};
        // The orientation of three points decides the side; the inner point may lie behind the camera.
        const glm::dvec3 a = screen.ray(p.world[0]);
        const glm::dvec3 plane = glm::cross(screen.orthographic() ? screen.direction() : a, p.world[1] - p.world[0]);
        const glm::dvec3 beside = screen.across(normal, p.world[0]);
        const bool innerSide = glm::dot(plane, segments[s].inner - p.world[0]) > 0.0;
        const bool normalSide = glm::dot(plane, beside) > 0.0;
        return innerSide == normalSide ? -normal : normal;
    }

    // Whether the surface ends at a point of a contour, a boundary or a crease seen edge-on, with nothing behind it.
    [[nodiscard]] bool endsBeforeNothing(std::uint32_t s, glm::dvec3 point) const {
        const Segment& segment = segments[s];
        const glm::dvec2 across = (outside + segment.slack / screen.footprint(point)) * outward(s);
        const auto surfaceAt = [&](glm::dvec2 beside) {
            return rays.meets(screen, point + screen.across(beside, point));
        };
        if (!surfaceAt(across)) return true;
        // What is seen edge-on ends to both sides.
        return segment.edgeOn && segment.curve != Curve::Contour && !surfaceAt(-across);
    }

    [[nodiscard]] Seen judge(std::uint32_t s, double at) const {
        const Segment& segment = segments[s];
        if (segment.hidden) return Seen::Hidden;
        const glm::dvec3 point = pointAt(s, at);
        const Slack slack = slackOf(segment, screen.footprint(point), components);
        if (rays.hides(screen, point, segment.faces, slack)) return Seen::Hidden;
        const bool isContour = segment.curve == Curve::Contour;
        const bool isBoundary = segment.curve == Curve::Boundary;
        const bool isCrease = segment.curve == Curve::Crease;
        const bool isOther = segment.curve == Curve::Marked || segment.curve == Curve::Tangent;
        const bool isMeshEdge = segment.slack == 0.0 && (isContour || isCrease || isBoundary || isOther);
        if (isMeshEdge && touching.isBehindFace(segment, point)) return Seen::Hidden;
        if (!isContour && !isCrease && !isBoundary) return Seen::Inside;
        const Touch touch = isBoundary ? touching.atBorder(segment, point) : Touch::None;
        if (touch == Touch::Begins) return Seen::Seam;
        if ((!isCrease || segment.edgeOn) && endsBeforeNothing(s, point)) return Seen::Outline;
        const bool isEdge = isCrease || (isContour && segment.slack == 0.0);
        const bool touches = touch == Touch::RunsOn || (isEdge && touching.atEdge(segment, point));
        return touches ? Seen::Contact : Seen::Inside;
    }
};

// The type of a line, whether or not it is drawn.
LineType typeOf(Curve curve, Seen seen) {
    if (seen == Seen::Contact) return LineType::Intersection;
    switch (curve) {
        case Curve::Contour:
            return seen == Seen::Outline ? LineType::Outline : LineType::Occlusion;
        case Curve::Boundary:
            return seen == Seen::Outline ? LineType::Outline : LineType::Boundary;
        case Curve::Crease:
            return seen == Seen::Outline ? LineType::Outline : LineType::Crease;
        case Curve::Intersection:
            return LineType::Intersection;
        case Curve::Isoparametric:
            return LineType::Isoparametric;
        case Curve::Marked:
            return LineType::Marked;
        case Curve::Suggestive:
            return LineType::Suggestive;
        case Curve::Ridge:
            return LineType::Ridge;
        case Curve::Valley:
            return LineType::Valley;
        case Curve::Apparent:
            return LineType::Apparent;
        case Curve::Tangent:
            return LineType::Tangent;
    }
    return LineType::Crease;
}

Isolines drawnIsolines(const RenderSettings& settings) {
    const bool drawn = settings.picture.lines.contains(LineType::Isoparametric);
    return drawn ? settings.lines.isolines : Isolines{};
}

void addIntersections(const std::vector<IntersectionSegment>& found, std::vector<Segment>& to) {
    std::uint32_t first = 0;  // of the numbers of the ends between two instances
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const IntersectionSegment& crossing = found[i];
        const bool samePair =
            i > 0 && crossing.a.instance == found[i - 1].a.instance && crossing.b.instance == found[i - 1].b.instance;
        if (!samePair) first = next;
        next = std::max({next, first + crossing.nodes[0] + 1, first + crossing.nodes[1] + 1});
        Segment& segment = to.emplace_back();
        segment.curve = Curve::Intersection;
        segment.occludes = false;
        segment.faces = {crossing.a, crossing.b};
        segment.ends = crossing.ends;
        for (std::size_t k = 0; k < 2; ++k) segment.keys[k] = intersectionKey(first + crossing.nodes[k]);
    }
}

// @param drawn  PictureSettings::lines
LineType typeOf(const Segment& segment, Seen seen, LineTypes drawn) {
    const LineType type = typeOf(segment.curve, seen);
    return segment.marked && !drawn.contains(type) ? LineType::Marked : type;
}

// @param drawn  PictureSettings::lines
Line makeLine(const ViewSegments& view, const Chain& chain, const Part& part, LineTypes drawn) {
    const Segment& first = view.segments[chain.links[static_cast<std::size_t>(part.begin)].segment];
    Line line;
    line.type = typeOf(first, part.seen, drawn);
    line.visible = isSeen(part.seen);
    line.object = first.faces[0].instance + 1;
    line.patch = first.faces[0].triangle == noTriangle ? 0 : scene::patchOf(view.scene, first.faces[0]);
    const auto add = [&](std::size_t link, double at) {
        const Chain::Link l = chain.links[link % chain.links.size()];
        const double own = l.reversed ? 1.0 - at : at;
        const auto& ends = view.projected[l.segment].ends;
        const glm::dvec2 pixel = ends[0].pixel + own * (ends[1].pixel - ends[0].pixel);
        const auto& strengths = view.segments[l.segment].strengths;
        line.points.push_back({pixel, view.pointAt(l.segment, own) + view.scene.bounds().centre,
                               strengths[0] + own * (strengths[1] - strengths[0])});
    };
    const auto begin = static_cast<std::size_t>(part.begin);
    add(begin, part.begin - static_cast<double>(begin));
    for (std::size_t joint = begin + 1; static_cast<double>(joint) < part.end; ++joint) add(joint, 0.0);
    const auto last = static_cast<std::size_t>(std::ceil(part.end)) - 1;
    add(last, part.end - static_cast<double>(last));
    if (chain.closed && part.begin == 0.0 && part.end == static_cast<double>(chain.links.size())) {
        line.closed = true;
        line.points.pop_back();
    }
    return line;
}

}  // namespace

// Views at the same time each go on from those that were done before.
struct ObjectLines::Memories {
    explicit Memories(std::size_t instances) : memories_(instances) {}

    [[nodiscard]] ContourMemory recall(std::uint32_t instance, ContourFinder finder) const {
        if (finder != ContourFinder::Random) return {};
        const std::scoped_lock lock{mutex_};
        return memories_[instance];
    }
    void remember(std::uint32_t instance, ContourMemory memory) {
        if (memory.sample == 0) return;  // nothing was looked for at random
        const std::scoped_lock lock{mutex_};
        memories_[instance] = std::move(memory);
    }

private:
    mutable std::mutex mutex_;
    std::vector<ContourMemory> memories_;  // one per instance
};

// It holds the scene, which therefore must not hold it.
struct ObjectLines::Prepared {
    explicit Prepared(const Scene& whole) : scene{whole} {
        base::Later<std::unique_ptr<const RayCaster>> raysToCome{
            [&] { return std::make_unique<const RayCaster>(scene); }, workOfTree * preparedOf(scene)->triangleCount};
        findEdgesOfMeshes();
        rays = raysToCome.take();
    }

    [[nodiscard]] std::span<const BorderSegment> bordersOf(std::uint32_t instance) const {
        const auto begin = std::ranges::lower_bound(borders, instance, {}, &BorderSegment::instance);
        const auto end = std::ranges::upper_bound(borders, instance, {}, &BorderSegment::instance);
        return {begin, end};
    }

    /// Those of the last levels asked for are kept.
    std::shared_ptr<const mesh::LimitSurfaces> limitOf(std::uint32_t mesh, int levels) const {
        const std::unique_lock lock = base::lockUnlessStopped(mutex_);
        limits_.resize(scene.meshes().size());
        if (!limits_[mesh] || limits_[mesh]->levels() != levels) {
            const Mesh& of = scene.meshes()[mesh];
            limits_[mesh] = std::make_shared<const mesh::LimitSurfaces>(
                mesh::controlMesh(of, scene::topologyOf(scene, mesh)), levels, of.origin);
        }
        return limits_[mesh];
    }

    // Found when they are first asked for: no other line needs the search.
    const std::vector<IntersectionSegment>& intersections() const {
        const std::unique_lock lock = base::lockUnlessStopped(intersectionsMutex_);
        if (!intersections_) intersections_ = findIntersections(scene, edges);
        return *intersections_;
    }

    // Finds them beside what goes on, the first time.
    [[nodiscard]] base::Later<const std::vector<IntersectionSegment>*> intersectionsToCome() const {
        const std::unique_lock lock = base::lockUnlessStopped(intersectionsMutex_);
        const std::size_t work = intersections_ ? 0 : workOfTree * preparedOf(scene)->triangleCount;
        return {[this] { return &intersections(); }, work};
    }

    // Null: the scene's surface is one.
    const SurfaceComponents* components() const {
        const std::unique_lock lock = base::lockUnlessStopped(mutex_);
        if (!components_) components_.emplace(scene, borders);
        return components_->areOne() ? nullptr : &*components_;
    }

    /// One per mesh. Those of the last feature size asked for are kept.
    std::shared_ptr<const std::vector<mesh::SurfaceForm>> forms(double featureSize) const {
        const std::unique_lock lock = base::lockUnlessStopped(mutex_);
        if (forms_ && formsOf_ == featureSize) return forms_;
        std::vector<mesh::SurfaceForm> found;
        for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
            base::stopIfAsked();
            found.push_back(mesh::surfaceForm(scene.meshes()[i], scene::topologyOf(scene, i), 0.01 * featureSize));
        }
        forms_ = std::make_shared<const std::vector<mesh::SurfaceForm>>(std::move(found));
        formsOf_ = featureSize;
        return forms_;
    }

    void addForm(const Screen& screen, const FormChoice& choice, std::vector<Segment>& to) const {
        if (choice.types.empty()) return;
        const auto formsOfMeshes = forms(choice.settings.featureSize);
        for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
            base::stopIfAsked();
            const std::uint32_t mesh = scene.instances()[i].mesh;
            if (!scene.meshes()[mesh].indices.empty())
                addFormLines(scene, i, (*formsOfMeshes)[mesh], edges[mesh], screen, choice, to);
        }
    }

    /// One per mesh. Those for the last steps asked for are kept.
    std::shared_ptr<const std::vector<std::vector<IsolineSegment>>> isolines(Isolines steps) const {
        const std::unique_lock lock = base::lockUnlessStopped(mutex_);
        if (isolines_ && isolineSteps_ == steps) return isolines_;
        std::vector<std::vector<IsolineSegment>> found(scene.meshes().size());
        if (steps != Isolines{}) {
            for (std::size_t i = 0; i < found.size(); ++i)
                found[i] = findIsolines(scene.meshes()[i], scene::topologyOf(scene, i), steps);
        }
        isolines_ = std::make_shared<const std::vector<std::vector<IsolineSegment>>>(std::move(found));
        isolineSteps_ = steps;
        return isolines_;
    }

    // The curves of all instances.
    [[nodiscard]] std::vector<Segment> curves(const Screen& screen, CurveChoice choice, Isolines steps,
                                              Memories& memories) const {
        std::vector<Segment> segments;
        const auto isolinesOfMeshes = isolines(steps);
        const int levels = choice.refinement;
        for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
            base::stopIfAsked();
            const std::uint32_t mesh = scene.instances()[i].mesh;
            if (scene.meshes()[mesh].indices.empty()) continue;
            choice.refinement = scene.meshes()[mesh].surfaces ? 0 : levels;
            const auto limit = choice.refinement > 0 ? limitOf(mesh, levels) : nullptr;
            choice.limit = limit.get();
            ContourMemory memory = memories.recall(i, choice.finder);
            collectInstanceCurves(scene, i, {*searches[mesh], bordersOf(i), (*isolinesOfMeshes)[mesh]}, memory, screen,
                                  choice, segments);
            memories.remember(i, std::move(memory));
        }
        return segments;
    }

    Scene scene;
    std::unique_ptr<const RayCaster> rays;
    std::vector<MeshEdges> edges;
    std::vector<std::unique_ptr<ContourSearch>> searches;  // one per mesh
    std::vector<BorderSegment> borders;
    std::vector<FileLines> fileLines;  // one per mesh

private:
    void findEdgesOfMeshes() {
        for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
            base::stopIfAsked();
            edges.push_back(findEdges(scene.meshes()[i], scene::topologyOf(scene, i), scene.creaseAngle()));
        }
        for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
            base::stopIfAsked();
            searches.push_back(
                std::make_unique<ContourSearch>(scene.meshes()[i], scene::topologyOf(scene, i), edges[i]));
        }
        borders = findBorderSegments(scene, edges);
        for (const Mesh& mesh : scene.meshes()) {
            base::stopIfAsked();
            fileLines.push_back(findFileLines(mesh));
        }
    }

    mutable std::timed_mutex intersectionsMutex_;
    mutable std::optional<std::vector<IntersectionSegment>> intersections_;
    mutable std::timed_mutex mutex_;  // of what else is made on first use
    mutable std::optional<SurfaceComponents> components_;
    mutable std::vector<std::shared_ptr<const mesh::LimitSurfaces>> limits_;
    mutable std::shared_ptr<const std::vector<std::vector<IsolineSegment>>> isolines_;
    mutable Isolines isolineSteps_;
    mutable std::shared_ptr<const std::vector<mesh::SurfaceForm>> forms_;
    mutable double formsOf_ = 0.0;  // the feature size
};

ObjectLines::ObjectLines(const Scene& scene)
    : prepared_{std::static_pointer_cast<const Prepared>(
          preparedOf(scene)->lines->get([&] { return std::shared_ptr<const Prepared>{new Prepared{scene}}; }))},
      memories_{std::make_unique<Memories>(scene.instances().size())} {}
ObjectLines::~ObjectLines() = default;

bool ObjectLines::holds(const Scene& scene) const noexcept {
    return scene::identityOf(prepared_->scene).lock() == scene::identityOf(scene).lock();
}

Lines ObjectLines::find(const Camera& camera, const RenderSettings& settings) const {
    return find(camera, settings, MarkedCreases::AreMarked);
}

Lines ObjectLines::findBesidePixels(const Camera& camera, const RenderSettings& settings) const {
    Lines lines = find(camera, settings, MarkedCreases::AreCreasesIfDrawn);
    std::erase_if(lines.lines, [](const Line& line) { return !typesBesidePixels.contains(line.type); });
    return lines;
}

Lines ObjectLines::find(const Camera& camera, const RenderSettings& settings, MarkedCreases markedCreases) const {
    const Scene& scene = prepared_->scene;
    Lines result;
    result.size = settings.picture.size;
    result.camera = camera;
    base::StageClock clock{result.times};

    const Screen screen{camera, scene.bounds().centre, settings.picture.size};
    std::optional<base::Later<const std::vector<IntersectionSegment>*>> intersections;
    if (settings.picture.lines.contains(LineType::Intersection))
        intersections.emplace(prepared_->intersectionsToCome());
    std::vector<Segment> segments = prepared_->curves(
        screen,
        {settings.lines.contour, settings.lines.contourFinder, settings.lines.subdivideAdaptive, nullptr,
         settings.lines.hidden, camera::standsOutside(camera, scene), settings.picture.lines, markedCreases},
        drawnIsolines(settings), *memories_);
    clock.finish("curves");
    const LineTypes forms = settings.picture.lines & formLineTypes;
    prepared_->addForm(
        screen, {forms, settings.lines.form, settings.lines.hidden, camera::standsOutside(camera, scene)}, segments);
    if (!forms.empty()) clock.finish("lines of form");
    if (settings.picture.lines.contains(LineType::Marked)) addFileLines(scene, prepared_->fileLines, segments);
    if (intersections) addIntersections(*intersections->get(), segments);
    clock.finish("intersections");
    std::vector<ScreenSegment> projected = project(segments, screen);
    const std::vector<Chain> chains = chainSegments(segments, projected);
    clock.finish("chains");
    const SurfaceComponents* const components = prepared_->components();
    const std::vector<Crossing> crossings = findCrossings(segments, projected, screen, components);
    std::vector<std::uint32_t> firstCrossings(segments.size() + 1, 0);
    for (const Crossing& crossing : crossings) ++firstCrossings[crossing.segment + 1];
    for (std::size_t s = 0; s < segments.size(); ++s) firstCrossings[s + 1] += firstCrossings[s];
    clock.finish("crossings");

    const RayCaster& rays = *prepared_->rays;
    const Touching touching{scene, rays, components, screen};
    const ViewSegments view{scene, rays, screen, components, touching, std::move(segments), std::move(projected)};
    std::vector<std::vector<Part>> parts(chains.size());
    const Judge judge = [&](std::uint32_t segment, double at) {
        base::stopIfAsked();
        return view.judge(segment, at);
    };
    base::onEach(chains.size(), [&](std::size_t c) {
        parts[c] = partChain(chains[c], view.projected, crossings, firstCrossings, judge);
    });
    clock.finish("visibility");

    const bool keepHidden = settings.lines.hidden != HiddenLines::None;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        for (const Part& part : parts[c])
            if (isSeen(part.seen) || (part.seen == Seen::Hidden && keepHidden))
                result.lines.push_back(makeLine(view, chains[c], part, settings.picture.lines));
    }
    result.lines = bridgeGaps(std::move(result.lines), screen, scene.bounds().centre);
    if (settings.lines.coincident == CoincidentLines::Merge) {
        result.lines = mergeCoincident(std::move(result.lines), settings.picture, screen, scene.bounds().centre);
    }
    clock.finish("lines");
    return result;
}

}  // namespace inkedge::lines
