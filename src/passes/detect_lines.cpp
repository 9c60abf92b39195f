#include "passes/detect_lines.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/trigonometric.hpp>

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/plane_uniforms.h"

namespace inkedge::passes {
namespace {

constexpr int blockSide = 4;  // pixels decided by one invocation along each axis

// Unpacks blocks of 4 x 4 bytes, as the shader packs them, into rows.
Image<std::uint8_t> unpack(const Image<std::uint8_t>& blocks, Size size) {
    Image<std::uint8_t> marks{size, 1};
    for (int y = 0; y < size.height; ++y) {
        const int row = y % blockSide;
        for (int x = 0; x < size.width; x += blockSide) {
            const std::uint8_t* from = &blocks(x / blockSide, y / blockSide, row * blockSide);
            std::copy_n(from, std::min(blockSide, size.width - x), &marks(x, y));
        }
    }
    return marks;
}

constexpr int regionRows = 64;  // few regions: drivers need microseconds for each
constexpr int step = sizeof(std::uint64_t);

bool anyMarked(const Image<std::uint8_t>& marks, int y, int x) {
    std::uint64_t some = 0;
    std::memcpy(&some, &marks(x, y), static_cast<std::size_t>(std::min(step, marks.size().width - x)));
    return some != 0;
}

struct Columns {
    int begin;
    int end;
};

// The columns, in whole steps, between the outermost marks of some rows; none if begin is not less than end.
Columns markedColumns(const Image<std::uint8_t>& marks, int firstRow, int endRow) {
    const int steps = (marks.size().width + step - 1) / step;
    int begin = steps;
    int end = 0;
    for (int y = firstRow; y < endRow; ++y) {
        for (int i = 0; i < begin; ++i) {
            if (anyMarked(marks, y, i * step)) begin = i;
        }
        for (int i = steps; i > end; --i) {
            if (anyMarked(marks, y, (i - 1) * step)) end = i;
        }
    }
    return {begin * step, end * step};
}

}  // namespace

Image<std::uint8_t> detectLines(const Frame& frame, const gl::Texture& planes, double creaseAngle) {
    gl::Gpu& gpu = frame.gpu;
    constexpr auto program = gl::Program::DetectLines;
    const Size size = planes.size();
    const double creaseCosine = std::cos(glm::radians(creaseAngle));
    const GLuint id = gpu.programs.id(program);
    setPlanes(frame, program);
    gpu.api.ProgramUniform1f(id, 3, static_cast<float>(creaseCosine * std::abs(creaseCosine)));

    const Size blocks{(size.width + blockSide - 1) / blockSide, (size.height + blockSide - 1) / blockSide};
    const gl::Texture marks = gpu.textures.acquire(blocks, GL_RGBA32UI);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&marks}}, {&planes});
    return unpack(gl::readPacked(gpu.api, marks), size);
}

std::vector<raster::Rectangle> regionsAround(const Image<std::uint8_t>& marks) {
    const auto [width, height] = marks.size();
    std::vector<raster::Rectangle> regions;
    for (int y = 0; y < height; y += regionRows) {
        const int rows = std::min(regionRows, height - y);
        const Columns columns = markedColumns(marks, std::max(y - 1, 0), std::min(y + rows + 1, height));
        if (columns.begin >= columns.end) continue;
        const int left = std::max(columns.begin - 1, 0);
        regions.push_back({left, y, {std::min(columns.end + 1, width) - left, rows}});
    }
    return regions;
}

}  // namespace inkedge::passes
