#include "io/pdf.h"

#include <inkedge/write.h>

#include "io/vector_formats.h"
#include "modules/failure.h"

namespace inkedge {

std::vector<std::uint8_t> io::pdfOf(const Drawing& drawing) {
    constexpr Error::Kind kind = Error::Kind::Output;
    return modules::expectNoFailure(modules::functionsOf<vectorModule>(kind).encodePdf(drawing), kind).bytes;
}

Image<std::uint8_t> io::pictureOf(const Drawing& drawing, Size size) {
    constexpr Error::Kind kind = Error::Kind::Output;
    return modules::expectNoFailure(modules::functionsOf<vectorModule>(kind).paint(drawing, size), kind).picture;
}

std::vector<std::uint8_t> linesPdf(const Lines& lines, const Settings& settings, std::string_view title) {
    return io::pdfOf(io::drawingOf(lines, settings, title, io::VaryingWidths::Outlines));
}

}  // namespace inkedge
