#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/camera.h>

#include "base/message.h"

namespace inkedge {
namespace {

constexpr double rounding = 1e-4;  // of rotations that were written with few digits
constexpr double noise = 1e-6;     // of entries that are 0 or 1
constexpr double square = 1e-9;    // of ratios that are 1

void expectSize(Size size) {
    if (size.width < 1 || size.height < 1)
        base::refuseUse(
            fmt::format("size: expected 1 pixel or more along each side, found {} x {}", size.width, size.height));
}

// A rotation and a translation.
void expectRigid(const glm::dmat4& matrix, std::string_view name) {
    const glm::dmat3 axes{matrix};
    const glm::dmat3 product = glm::transpose(axes) * axes;
    double off = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            off = std::max(off, std::abs(product[column][row] - (column == row ? 1.0 : 0.0)));
    double moved = 0.0;
    for (int row = 0; row < 3; ++row) moved += matrix[3][row];
    const bool affine = glm::row(matrix, 3) == glm::dvec4{0.0, 0.0, 0.0, 1.0};
    if (std::isfinite(moved) && affine && off <= rounding && glm::determinant(axes) > 0.0) return;
    base::refuseUse(
        fmt::format("{}: expected a rotation and a translation, its last row 0, 0, 0, 1, found a matrix that is "
                    "none; take scales and mirrors out of it",
                    name));
}

// Whose pixels are far from squares was made for a picture of another shape.
void expectAspect(double pixelAspect, Size size, bool orthographic) {
    constexpr double calibrated = 1.1;  // pixels of cameras are squares within a hundredth
    constexpr double unseen = 0.05;     // pixels at the picture's edge
    const double ratio = std::max(pixelAspect, 1.0 / pixelAspect);
    if (ratio < calibrated && (!orthographic || (ratio - 1.0) * 0.5 * size.width <= unseen)) return;
    base::refuseUse(
        fmt::format("projection: expected one for a picture of {} x {}, found one whose pixels are {:.6g} times as "
                    "wide as high there; make it for the picture's aspect",
                    size.width, size.height, pixelAspect));
}

double pixelAspectOf(double focalX, double focalY) {
    const double ratio = focalY / focalX;
    return std::abs(ratio - 1.0) <= square ? 1.0 : ratio;
}

double angleOf(double slope) { return glm::degrees(2.0 * std::atan(slope)); }

bool isNear(double value, double expected) { return std::abs(value - expected) <= noise; }

// Whether all but the named entries are 0; column, row.
template <class Matrix>
bool isZeroBut(const Matrix& matrix, std::initializer_list<glm::ivec2> entries) {
    for (int column = 0; column < Matrix::length(); ++column) {
        for (int row = 0; row < Matrix::length(); ++row) {
            const bool named = std::ranges::find(entries, glm::ivec2{column, row}) != entries.end();
            if (!std::isfinite(matrix[column][row]) || (!named && !isNear(matrix[column][row], 0.0))) return false;
        }
    }
    return true;
}

void setPerspective(Camera& camera, const glm::dmat4& p) {
    camera.viewAngle = angleOf(1.0 / p[1][1]);
    camera.axis = {-p[2][0], -p[2][1]};
    if (p[2][2] == -1.0) return;  // an infinite far plane
    camera.near = p[3][2] / (p[2][2] - 1.0);
    camera.far = p[3][2] / (p[2][2] + 1.0);
}

void setOrthographic(Camera& camera, const glm::dmat4& p) {
    camera.orthographicHeight = 2.0 / p[1][1];
    camera.axis = {p[3][0], p[3][1]};
    camera.near = (p[3][2] + 1.0) / p[2][2];
    camera.far = (p[3][2] - 1.0) / p[2][2];
}

}  // namespace

Camera cameraFromIntrinsics(const glm::dmat3& k, const glm::dmat4& pose, CameraAxes axes, Size size) {
    expectSize(size);
    expectRigid(pose, "pose");
    const double focalX = k[0][0];
    const double focalY = k[1][1];
    if (!isZeroBut(k, {{0, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}}) || !isNear(k[2][2], 1.0) ||
        !(focalX > 0.0 && focalY > 0.0))
        base::refuseUse(
            "K: expected the rows (fx, 0, cx), (0, fy, cy) and (0, 0, 1), fx and fy over 0, found another matrix; "
            "undistort what it was made for");
    Camera camera;
    camera.pixelAspect = pixelAspectOf(focalX, focalY);
    camera.view = glm::inverse(pose);
    if (axes == CameraAxes::OpenCv) camera.view = camera.worldToCamera();  // turns back, too
    camera.viewAngle = angleOf(0.5 * size.height / focalY);
    const glm::dvec2 middle{k[2][0] + 0.5, k[2][1] + 0.5};
    camera.axis = {2.0 * middle.x / size.width - 1.0, 1.0 - 2.0 * middle.y / size.height};
    return camera;
}

Camera cameraFromMatrices(const glm::dmat4& view, const glm::dmat4& projection, Size size) {
    expectSize(size);
    expectRigid(view, "view");
    const glm::dmat4& p = projection;
    const bool perspective =
        isZeroBut(p, {{0, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {2, 3}, {3, 2}}) && isNear(p[2][3], -1.0);
    const bool orthographic =
        isZeroBut(p, {{0, 0}, {1, 1}, {2, 2}, {3, 0}, {3, 1}, {3, 2}, {3, 3}}) && isNear(p[3][3], 1.0);
    if (!(perspective || orthographic) || !(p[0][0] > 0.0 && p[1][1] > 0.0))
        base::refuseUse("projection: expected OpenGL's, perspective or orthographic, found another matrix");
    Camera camera;
    camera.pixelAspect = pixelAspectOf(p[0][0] * size.width, p[1][1] * size.height);
    expectAspect(camera.pixelAspect, size, orthographic);
    camera.view = view;
    (perspective ? setPerspective : setOrthographic)(camera, p);
    const bool fitted = camera.far == 0.0;
    if (!fitted && !(camera.near < camera.far && (orthographic || camera.near > 0.0)))
        base::refuseUse(
            fmt::format("projection: expected near and far planes that follow each other in front of the eye, found "
                        "{:.6g} and {:.6g}",
                        camera.near, camera.far));
    return camera;
}

}  // namespace inkedge
