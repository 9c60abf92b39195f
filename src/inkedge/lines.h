#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/backends.h>
#include <inkedge/bounds.h>
#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/scene.h>
#include <inkedge/scene_names.h>
#include <inkedge/settings.h>
#include <inkedge/stage_time.h>

namespace inkedge {

/// A point of a line: in the picture and in the world.
struct LinePoint {
    glm::dvec2 pixel;     ///< output pixels, (0, 0) the picture's top left corner, y down; not rounded
    glm::dvec3 position;  ///< world space
    /// Of lines of form: from 0, as weak as is drawn, to 1, as strong as makes no difference any more.
    double strength = 1.0;
};

/// A polyline of one type, all of it seen or all of it hidden. It lies in front of the near plane; it may reach beyond
/// the picture's edge.
struct Line {
    LineType type = LineType::Outline;
    bool visible = true;
    bool closed = false;  ///< the last point is joined to the first, which is not repeated
    /// From 1, one of its own among the lines of a view; 0: the line has none. The same scene, camera and settings give
    /// the same line the same id, unless ContourFinder::Random looked for it: that finds other lines each time. With
    /// other settings, or another camera, lines are numbered anew.
    std::uint32_t id = 0;
    std::uint32_t object = 0;  ///< the instance that the line lies on, as in Maps::ids: from 1
    /// The patch that the line lies on, as in Maps::ids: from 1. Between two patches, the nearer one.
    std::uint32_t patch = 0;
    std::vector<LinePoint> points;  ///< two or more
    /// Share of its pen's width, over 0 and at most 1: under 1 where it stands for a part thinner than a pixel.
    double width = 1.0;
};

/// What lines were found on, and by what.
struct LinesSource {
    std::string name;                             ///< of the model's file, without its folder; empty: no file
    std::string format;                           ///< as SceneSource::format
    LengthUnit unit = LengthUnit::None;           ///< of world space
    std::uint64_t triangles = 0;                  ///< as Scene::triangleCount()
    std::vector<std::string> warnings;            ///< as Scene::warnings()
    LinesFrom space = LinesFrom::Object;          ///< Object or Image, never Auto
    ContourFinder finder = ContourFinder::Every;  ///< of lines from object space
    Detector detector = Detector::Planes;         ///< of lines from image space
};

/// The lines of one view: all that drawing, writing and comparing them needs.
struct Lines {
    std::vector<Line> lines;
    Size size;  ///< of the picture that LinePoint::pixel counts in
    Camera camera;
    Sphere bounds;  ///< world space, around the whole model: Scene::bounds()
    LinesSource source;
    SceneNames names;           ///< of the instances that lines lie on, and of all materials
    Image<std::uint8_t> shade;  ///< as Maps::shade, of the picture's size; empty: none is asked for, or a file was read
    double tolerance = 0.0;     ///< pixels by which points may stray from the lines found: over 0 where a file was read
    BackendInfo backend;        ///< the renderer's; empty while it has no context, for nothing was drawn to find them
    std::vector<StageTime> times;
    /// One line each: what the settings ask for and the scene has nothing for, as renderWarnings() gives it.
    std::vector<std::string> warnings;
};

}  // namespace inkedge
