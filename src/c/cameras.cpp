#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <inkedge/views.h>

#include "c/handles.h"

namespace inkedge::c {
namespace {

template <class Matrix>
Matrix matrixFrom(const double* rows) {
    Matrix matrix;
    for (int row = 0; row < Matrix::length(); ++row)
        for (int column = 0; column < Matrix::length(); ++column) matrix[column][row] = *rows++;
    return matrix;
}

template <class Matrix>
void write(const Matrix& matrix, double* rows) {
    for (int row = 0; row < Matrix::length(); ++row)
        for (int column = 0; column < Matrix::length(); ++column) *rows++ = matrix[column][row];
}

}  // namespace
}  // namespace inkedge::c

using namespace inkedge::c;

inkedge_status inkedge_camera_frame(const inkedge_scene* scene, const inkedge_settings* settings,
                                    inkedge_camera** camera) {
    return handOut(camera, [&] {
        const inkedge::Settings value = valueOf(settings);
        const inkedge::View view{.name = {}, .camera = value.camera};
        return new inkedge_camera{inkedge::frameViews(given(scene, "scene").value, {&view, 1}, value).front().camera};
    });
}

inkedge_status inkedge_camera_from_intrinsics(const double k[9], const double pose[16], int opencv, int32_t width,
                                              int32_t height, inkedge_camera** camera) {
    return handOut(camera, [&] {
        return new inkedge_camera{inkedge::cameraFromIntrinsics(
            matrixFrom<glm::dmat3>(&given(k, "k")), matrixFrom<glm::dmat4>(&given(pose, "pose")),
            opencv != 0 ? inkedge::CameraAxes::OpenCv : inkedge::CameraAxes::OpenGl, {width, height})};
    });
}

inkedge_status inkedge_camera_from_matrices(const double view[16], const double projection[16], int32_t width,
                                            int32_t height, inkedge_camera** camera) {
    return handOut(camera, [&] {
        return new inkedge_camera{inkedge::cameraFromMatrices(matrixFrom<glm::dmat4>(&given(view, "view")),
                                                              matrixFrom<glm::dmat4>(&given(projection, "projection")),
                                                              {width, height})};
    });
}

void inkedge_camera_free(inkedge_camera* camera) { delete camera; }

void inkedge_camera_view(const inkedge_camera* camera, double view[16]) { write(camera->value.view, view); }

void inkedge_camera_projection(const inkedge_camera* camera, const inkedge_scene* scene, int32_t width, int32_t height,
                               double projection[16]) {
    write(inkedge::withPlanes(camera->value, scene->value).projection({width, height}), projection);
}

void inkedge_camera_intrinsics(const inkedge_camera* camera, int32_t width, int32_t height, double k[9]) {
    write(camera->value.intrinsics({width, height}), k);
}

void inkedge_camera_world_to_camera(const inkedge_camera* camera, double matrix[16]) {
    write(camera->value.worldToCamera(), matrix);
}
