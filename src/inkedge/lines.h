#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/backends.h>
#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/settings.h>
#include <inkedge/stage_time.h>

namespace inkedge {

/// A point of a line: in the picture and in the world.
struct LinePoint {
    glm::dvec2 pixel;     ///< output pixels, (0, 0) the picture's top left corner, y down; not rounded
    glm::dvec3 position;  ///< world space
};

/// A polyline of one type, all of it seen or all of it hidden. It lies in front of the near plane; it may reach beyond
/// the picture's edge.
struct Line {
    LineType type = LineType::Outline;
    bool visible = true;
    bool closed = false;       ///< the last point is joined to the first, which is not repeated
    std::uint32_t object = 0;  ///< the node that the line lies on, as in Maps::ids: from 1
    /// The patch that the line lies on, as in Maps::ids: from 1. Between two patches, the nearer one.
    std::uint32_t patch = 0;
    std::vector<LinePoint> points;  ///< two or more
};

/// The lines of one view.
struct Lines {
    std::vector<Line> lines;
    Size size;  ///< of the picture that LinePoint::pixel counts in
    Camera camera;
    BackendInfo backend;  ///< the renderer's; empty while it has no context, for nothing was drawn to find them
    std::vector<StageTime> times;
    /// One line each: what the settings ask for and the scene has nothing for, as renderWarnings() gives it.
    std::vector<std::string> warnings;
};

}  // namespace inkedge
