#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <inkedge/camera.h>
#include <inkedge/scene.h>

#include "scenes.h"

/// Scenes of boxes, cylinders and open sheets that stand at exact and at nearly exact distances, and views of them.
namespace inkedge::render::random_scenes {

struct RandomScene {
    std::vector<std::pair<Mesh, glm::dmat4>> parts;
    CameraSettings view;
    std::string text;  ///< what it is made of
};

/// The same scene for a seed on every machine.
class Maker {
public:
    explicit Maker(std::uint32_t seed) : numbers_{seed} {}

    RandomScene make() {
        const std::size_t count = 2 + below(4);
        for (std::size_t i = 0; i < count; ++i) addPart();
        turn();
        look();
        return std::move(scene_);
    }

private:
    struct Bounds {
        glm::dvec3 low;
        glm::dvec3 high;
    };

    std::size_t below(std::size_t limit) { return numbers_() % limit; }
    bool oneIn(std::size_t count) { return below(count) == 0; }
    double share() { return static_cast<double>(numbers_()) * 0x1p-32; }
    double between(double low, double high) { return low + share() * (high - low); }

    // Around the y axis; each side has corners of its own, as exporters write them, or the sides share theirs.
    static Mesh cylinder(double radius, double height, std::uint32_t facets) {
        Mesh mesh;
        mesh.name = "cylinder";
        for (const double y : {-0.5 * height, 0.5 * height}) {
            for (std::uint32_t i = 0; i < facets; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / facets;
                mesh.positions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
            }
        }
        for (std::uint32_t i = 0; i < facets; ++i) {
            const std::uint32_t next = (i + 1) % facets;
            mesh.indices.insert(mesh.indices.end(), {i, i + facets, next + facets, i, next + facets, next});
        }
        for (std::uint32_t i = 1; i + 1 < facets; ++i)
            mesh.indices.insert(mesh.indices.end(), {0, i, i + 1, facets, facets + i + 1, facets + i});
        return mesh;
    }

    static Mesh along(Mesh mesh, std::size_t axis) {  // from the y axis
        for (glm::vec3& p : mesh.positions) {
            const glm::vec3 q = p;
            for (int k = 0; k < 3; ++k) p[static_cast<int>((axis + static_cast<std::size_t>(k) + 2) % 3)] = q[k];
        }
        return mesh;
    }

    Mesh someMesh() {
        const auto side = [&] { return oneIn(3) ? between(0.2, 2.0) : 0.25 * static_cast<double>(1 + below(8)); };
        const std::size_t kind = below(10);
        const std::size_t axis = below(3);
        if (kind < 5) {
            const glm::dvec3 sides{side(), side(), side()};
            scene_.text += fmt::format("box {:.3g} {:.3g} {:.3g}", sides.x, sides.y, sides.z);
            return scenes::box(sides);
        }
        if (kind < 8) {
            constexpr std::array<std::uint32_t, 7> facets{5, 6, 8, 16, 24, 33, 48};
            hasRound_ = true;
            const double radius = 0.5 * side();
            const double height = side();
            const std::uint32_t count = facets[below(facets.size())];
            scene_.text += fmt::format("cylinder of {} facets, {:.3g} {:.3g} axis {}", count, radius, height, axis);
            return along(cylinder(radius, height, count), axis);
        }
        const double width = 0.5 * side();
        const double depth = 0.5 * side();
        scene_.text += fmt::format("sheet {:.3g} {:.3g} axis {}", 2.0 * width, 2.0 * depth, axis);
        return along(scenes::quad({-width, 0, depth}, {width, 0, depth}, {width, 0, -depth}, {-width, 0, -depth}),
                     axis);
    }

    static Bounds boundsOf(const Mesh& mesh) {
        Bounds bounds{glm::dvec3{mesh.positions[0]}, glm::dvec3{mesh.positions[0]}};
        for (const glm::vec3 p : mesh.positions) {
            bounds.low = glm::min(bounds.low, glm::dvec3{p});
            bounds.high = glm::max(bounds.high, glm::dvec3{p});
        }
        return bounds;
    }

    // Nearly exact ones are less than the rounding that both sources allow for. Round parts are not sunk by a little:
    // surfaces that cross at less than minIntersectionAngle have no line in object space.
    double someGap(bool isRound) {
        constexpr std::array gaps{0.0, 0.0, 0.0, 0.0, 1e-7, -1e-7, 3e-7, -3e-7, 1e-3, 0.02, 0.25, -0.25, -1e-3};
        return gaps[below(isRound ? gaps.size() - 1 : gaps.size())];
    }

    // Beside a part that is there, flush with it or not.
    void addPart() {
        const Mesh mesh = someMesh();
        const Bounds own = boundsOf(mesh);
        glm::dvec3 at{0.0};
        if (!bounds_.empty()) {
            const Bounds& other = bounds_[below(bounds_.size())];
            const int across = static_cast<int>(below(3));
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t how = axis == across ? below(2) : 2 + below(4);
                if (how == 0) at[axis] = other.high[axis] - own.low[axis];
                if (how == 1) at[axis] = other.low[axis] - own.high[axis];
                if (how == 2) at[axis] = other.low[axis] - own.low[axis];
                if (how == 3) at[axis] = other.high[axis] - own.high[axis];
                if (how == 4) at[axis] = 0.5 * (other.low[axis] + other.high[axis]);
                if (how == 5) at[axis] = between(other.low[axis], other.high[axis]);
                const double gap = axis == across || oneIn(4) ? someGap(hasRound_) : 0.0;
                at[axis] += how == 1 ? -gap : gap;
                scene_.text += fmt::format(", {} {:.3g} gap {:.3g}", how, at[axis], gap);
            }
        }
        scene_.text += "; ";
        bounds_.push_back({own.low + at, own.high + at});
        scene_.parts.emplace_back(mesh, scenes::translation(at));
    }

    // All parts together: not at all, by a quarter or an eighth of a turn, or anyhow; by transforms or in positions.
    void turn() {
        const std::size_t how = below(4);
        if (how == 0) return;
        const glm::dvec3 axis =
            how < 3 ? glm::dvec3{0, 1, 0} : glm::normalize(glm::dvec3{share(), share() + 0.1, share()});
        const double degrees = how == 1 ? 90.0 : how == 2 ? 45.0 : between(5.0, 85.0);
        const bool inPositions = oneIn(2);
        scene_.text += fmt::format("turned {:.3g}{}; ", degrees, inPositions ? " in the positions" : "");
        for (auto& [mesh, transform] : scene_.parts) {
            transform = scenes::rotation(degrees, axis) * transform;
            if (!inPositions) continue;
            for (glm::vec3& p : mesh.positions) p = glm::vec3{transform * glm::dvec4{glm::dvec3{p}, 1.0}};
            transform = glm::dmat4{1.0};
        }
    }

    void look() {
        const bool exact = oneIn(2);
        scene_.view.azimuthAngle = exact ? 45.0 * static_cast<double>(below(8)) : between(0.0, 360.0);
        scene_.view.elevationAngle = exact ? 45.0 * static_cast<double>(below(5)) - 90.0 : between(-80.0, 80.0);
        if (oneIn(2)) scene_.view.orthographicHeight = 0.0;
        scene_.text += fmt::format("{}, azimuth {:.4g}, elevation {:.4g}",
                                   scene_.view.orthographicHeight ? "orthographic" : "perspective",
                                   *scene_.view.azimuthAngle, *scene_.view.elevationAngle);
    }

    std::mt19937 numbers_;
    RandomScene scene_;
    std::vector<Bounds> bounds_;
    bool hasRound_ = false;
};

inline RandomScene randomScene(std::uint32_t seed) { return Maker{seed}.make(); }

}  // namespace inkedge::render::random_scenes
