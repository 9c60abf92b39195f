#include "batch/agreement.h"

#include <tuple>
#include <utility>

#include <inkedge/compare_lines.h>

#include "diff/samples.h"

namespace inkedge::batch {
namespace {

// Lines that are seen, in the picture.
ComparedLines seenLines(const Lines& lines) {
    ComparedLines seen = comparedLines(lines);
    std::erase_if(seen.lines, [](const ComparedLine& line) { return !line.visible; });
    return seen;
}

// The length of all lines, and of what of them is near to others.
std::pair<double, double> lengthsNear(const diff::SampledLines& lines, const diff::SegmentGrid& others) {
    double all = 0.0;
    double near = 0.0;
    for (const diff::Sample& sample : lines.samples) {
        all += sample.length;
        if (others.hasNear(sample.at)) near += sample.length;
    }
    return {all, near};
}

}  // namespace

double Agreement::f1() const noexcept {
    const double sum = precision() + recall();
    return sum > 0.0 ? 2.0 * precision() * recall() / sum : 0.0;
}

Agreement& Agreement::operator+=(const Agreement& other) noexcept {
    image += other.image;
    imageNear += other.imageNear;
    object += other.object;
    objectNear += other.objectNear;
    return *this;
}

Agreement agreementOf(const Lines& image, const Lines& object) {
    const diff::SampledLines ofImage{seenLines(image).lines};
    const diff::SampledLines ofObject{seenLines(object).lines};
    Agreement agreement;
    std::tie(agreement.image, agreement.imageNear) =
        lengthsNear(ofImage, {ofObject.segments, object.size, agreementReach});
    std::tie(agreement.object, agreement.objectNear) =
        lengthsNear(ofObject, {ofImage.segments, image.size, agreementReach});
    return agreement;
}

}  // namespace inkedge::batch
