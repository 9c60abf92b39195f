#include "opencv_edges.h"

#include <array>
#include <span>

#include "reference/reference.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "passes/edge_marks.h"

namespace inkedge::benchmarks {
namespace {

constexpr int depthChannel = 3;

cv::Mat column(std::span<const double> taps) {
    cv::Mat kernel(static_cast<int>(taps.size()), 1, CV_32F);  // braces would make a list of three numbers
    for (std::size_t i = 0; i < taps.size(); ++i) kernel.at<float>(static_cast<int>(i)) = static_cast<float>(taps[i]);
    return kernel;
}

}  // namespace

struct OpenCvEdges::Buffers {
    std::array<cv::Mat, 4> channels;
    std::array<double, 4> thresholds;
    cv::Mat smoothing;
    cv::Mat derivative;
    cv::Mat alongX;
    cv::Mat alongY;
    cv::Mat magnitude;
    cv::Mat over;
    cv::Mat marks;
};

OpenCvEdges::OpenCvEdges(const Image<float>& surface, Kernel kernel, Thresholds thresholds)
    : buffers_{std::make_unique<Buffers>()} {
    cv::setNumThreads(1);
    const cv::Mat interleaved(surface.size.height, surface.size.width, CV_32FC4,
                              const_cast<float*>(surface.pixels().data()));  // split() only reads it
    cv::split(interleaved, buffers_->channels.data());
    buffers_->thresholds = {thresholds.normal, thresholds.normal, thresholds.normal, thresholds.depth};
    const bool farid = kernel == Kernel::Farid;
    buffers_->smoothing = farid ? column(reference::faridSmoothing) : column(reference::sobelSmoothing);
    buffers_->derivative = farid ? column(reference::faridDerivative) : column(reference::sobelDerivative);
    buffers_->marks.create(surface.size.height, surface.size.width, CV_8U);
}

OpenCvEdges::~OpenCvEdges() = default;

const std::uint8_t* OpenCvEdges::detect() {
    Buffers& b = *buffers_;
    b.marks.setTo(0);
    for (int channel = 0; channel < 4; ++channel) {
        const auto c = static_cast<std::size_t>(channel);
        const unsigned bit = channel == depthChannel ? EdgeMarks::depthEdge : EdgeMarks::normalEdge;
        cv::sepFilter2D(b.channels[c], b.alongX, CV_32F, b.derivative, b.smoothing, {-1, -1}, 0.0,
                        cv::BORDER_REPLICATE);
        cv::sepFilter2D(b.channels[c], b.alongY, CV_32F, b.smoothing, b.derivative, {-1, -1}, 0.0,
                        cv::BORDER_REPLICATE);
        cv::magnitude(b.alongX, b.alongY, b.magnitude);
        cv::compare(b.magnitude, b.thresholds[c], b.over, cv::CMP_GE);
        cv::bitwise_and(b.over, static_cast<double>(bit), b.over);
        cv::bitwise_or(b.marks, b.over, b.marks);
    }
    return b.marks.data;
}

}  // namespace inkedge::benchmarks
