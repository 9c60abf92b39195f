#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/line_types.h>

#include "raster/pair_mark.h"
#include "scene/scene_face.h"
#include "trace/line_buffers.h"
#include "trace/screen_triangles.h"

namespace inkedge::trace {

/// A line across the step between two neighbouring samples.
struct StepCrossing {
    glm::vec2 position;         ///< samples of the whole picture
    LineTypes types;            ///< empty: there is no line
    float inverseDepth = 0.0F;  ///< as TracedPiece has it
    scene::SceneFace face;      ///< that the line belongs to: the nearer one; where surfaces meet see owner()
    float width = 1.0F;         ///< as TracedPiece has it
};

/// The crossings of one row of samples with their neighbours to the right and below.
struct CrossingRow {
    explicit CrossingRow(int width)
        : right(static_cast<std::size_t>(width)), down(right), rightStrips(right), downStrips(right) {}

    /// Most samples have no crossings: only those that have are cleared.
    void clear() {
        for (std::vector<StepCrossing>* const steps : {&right, &down, &rightStrips, &downStrips})
            for (const int column : columns) (*steps)[static_cast<std::size_t>(column)].types = {};
        columns.clear();
    }

    std::vector<StepCrossing> right;
    std::vector<StepCrossing> down;
    /// Creases less than a sample from where their surface ends: some samples see the strip between the two lines, and
    /// others do not. They are as wide as it, and stand beside the other line.
    std::vector<StepCrossing> rightStrips;
    std::vector<StepCrossing> downStrips;
    std::vector<int> columns;  ///< of samples with crossings, ascending
};

/// Finds out where a line crosses the step between two neighbouring samples, and what it is.
class CrossingTracer {
public:
    /// @param triangles  as the camera projects them onto the whole picture's samples
    /// All three must outlive it.
    CrossingTracer(const LineBuffers&, const ScreenTriangles& triangles, const Camera&);

    /// @param y  in the tile
    void traceRow(int y, CrossingRow&);

    /// Maps::types at the nearer sample of each crossing traced so far.
    [[nodiscard]] Image<std::uint16_t> takeTypes() { return std::move(types_); }

private:
    // The coordinates of a sample in its tile.
    struct Sample {
        int x;
        int y;
    };
    using End = ScreenTriangles::End;
    using Exit = ScreenTriangles::Exit;
    using Plane = ScreenTriangles::Plane;
    using Walk = ScreenTriangles::Walk;
    // The step from the nearer of two neighbouring samples to the other one.
    struct Step {
        Sample near;
        Sample far;
        unsigned marks;
        Walk way;    // over the near sample's patch
        Walk whole;  // over its surface
        // Only where the surfaces do not jump:
        Walk farWay;  // over the far sample's patch, towards the near one
        Walk back;    // over its surface
        bool bends;   // whether the surfaces meet in a crease
        // In any case:
        bool passesStrip;  // whether the near surface bends in front of the far one and, a little further, ends
        [[nodiscard]] bool jumps() const noexcept {
            return (marks & (raster::PairMark::background | raster::PairMark::jump)) != 0;
        }
    };

    [[nodiscard]] bool isBackground(Sample) const;
    [[nodiscard]] scene::SceneFace triangle(Sample) const;
    [[nodiscard]] glm::dvec2 centre(Sample) const;  // in the whole picture
    [[nodiscard]] ScreenTriangles::BothWalks walk(Sample from, Sample to) const;
    [[nodiscard]] std::optional<ScreenTriangles::LayerBorder> layerBorder(Sample from, Sample to) const;
    [[nodiscard]] Plane plane(Sample) const;
    [[nodiscard]] glm::dvec3 normal(Sample) const;
    [[nodiscard]] bool bendsByCreaseAngle(Sample, Sample) const;
    [[nodiscard]] bool isNearer(Sample q, Sample p) const;
    [[nodiscard]] std::optional<double> planesMeet(Sample p, Sample q) const;
    [[nodiscard]] double positionAlong(const Step&) const;
    void cross(Sample p, Sample q, unsigned marks, StepCrossing& line, StepCrossing& strip);
    [[nodiscard]] StepCrossing crossing(const Step&);
    [[nodiscard]] bool passesStrip(const Step&) const;
    [[nodiscard]] StepCrossing creaseOfStrip(const Step&) const;
    [[nodiscard]] float stripWidth(const Step&, glm::dvec2 crease) const;
    [[nodiscard]] double endBeyond(Sample from, Sample at) const;
    [[nodiscard]] float inverseDepthAt(Sample, glm::dvec2 offset) const;
    [[nodiscard]] bool arrives(const Walk&, Sample from, Sample to) const;
    [[nodiscard]] bool goesOnSmoothly(const Step&) const;
    [[nodiscard]] bool isBend(const Step&) const;
    [[nodiscard]] bool isSeam(const Step&) const;
    [[nodiscard]] double gap(scene::SceneFace front, scene::SceneFace behind, glm::dvec2 at) const;
    [[nodiscard]] bool touches(Sample from, Sample to, std::uint32_t face, double t) const;
    [[nodiscard]] LineTypes meeting(const Step&) const;
    [[nodiscard]] LineTypes classify(const Step&) const;
    [[nodiscard]] bool farOwns(const Step&) const;
    [[nodiscard]] scene::SceneFace owner(const Step&) const;

    const LineBuffers& buffers_;
    const ScreenTriangles& triangles_;
    bool orthographic_;
    glm::dvec2 focalLengths_;
    glm::dvec2 centre_;  // that the view axis meets
    double creaseCosine_;
    raster::Rectangle columns_;
    Image<std::uint16_t> types_;
};

}  // namespace inkedge::trace
