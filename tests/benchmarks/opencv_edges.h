#pragma once

#include <cstdint>
#include <memory>

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge::benchmarks {

/// The classic detector's work by OpenCV in one thread: for each of depth and three normals sepFilter2D along x and
/// along y, magnitude and threshold.
class OpenCvEdges {
public:
    /// @param surface  4 channels: normal, depth scaled to 0..1
    OpenCvEdges(const Image<float>& surface, Kernel, Thresholds);
    ~OpenCvEdges();

    /// @return  EdgeMarks bits, one byte a pixel, valid until the next call
    const std::uint8_t* detect();

private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

}  // namespace inkedge::benchmarks
