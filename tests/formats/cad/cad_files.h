#pragma once

#include <string>
#include <vector>

namespace inkedge::cad_files {

/// Shapes whose every point is known. Millimetres; round ones stand on the origin and turn about z.
enum class Shape {
    Box,            ///< (0, 0, 0) to (10, 20, 30)
    Cylinder,       ///< radius 5, height 12
    Halves,         ///< the same cylinder, its side in two faces
    Cone,           ///< radius 6 at z = 0, apex at z = 8
    Sphere,         ///< radius 4 about the origin
    Torus,          ///< radii 8 and 3
    Rounded,        ///< the box, its four edges along z rounded by 2
    SplineTorus,    ///< the torus as B-spline surfaces
    SplineCone,     ///< the cone as B-spline surfaces
    OffsetTorus,    ///< the torus as an offset of a B-spline surface; BREP alone has that
    ScaledTorus,    ///< the torus as one of half its size, mirrored and scaled where it stands; likewise
    SplineHalves,   ///< the halves as B-spline surfaces
    Extruded,       ///< a B-spline curve moved by 5 along z
    Revolved,       ///< a B-spline curve turned about z
    OpenBox,        ///< the box without its top
    Pieces,         ///< the faces of the box, which share no edge
    Crossing,       ///< two solids: the box, and a cylinder of radius 4 about (x, 10, 15) for x of -10 to 20
    Moved,          ///< a cylinder of radius 5 and height 12 about the x axis from (100, 0, 0) on
    ManyHoles,      ///< a face of 100 x 100 at z = 0 with 64 square holes of 4, and two of radius 8 that cross
    Corner,         ///< of a square of 19, rounded, what lies outside a circle of 9.51 about its middle
    Mirrored,       ///< the box with faces turned over, at (-10, 0, 0) to (0, 20, 30)
    CurvesAndPoint  ///< the box with two curves and a point beside it
};

/// A STEP file of schema "AP203", "AP214IS" or "AP242DIS".
[[nodiscard]] std::string step(Shape, const std::string& schema = "AP214IS", const std::string& unit = "MM");
[[nodiscard]] std::string iges(Shape);
[[nodiscard]] std::string brep(Shape);

/// A STEP file of a shape times a scale about the origin.
[[nodiscard]] std::string scaledStep(Shape, double scale);

/// A STEP file of an assembly: "table" holds two of the red "leg", a box of 2 x 2 x 10 at x = 0 and x = 20, and a blue
/// "plate" over them, with a green top.
[[nodiscard]] std::string assembly();

}  // namespace inkedge::cad_files
