#include "sheet/page.h"

#include <array>

#include <fmt/format.h>

namespace inkedge::sheet {
namespace {

constexpr std::array<glm::dvec2, 5> sizes{glm::dvec2{1189, 841}, {841, 594}, {594, 420}, {420, 297}, {297, 210}};
constexpr int smallestSeries = 4;

}  // namespace

glm::dvec2 sizeOf(const SheetPage& page) noexcept {
    const glm::dvec2 size = sizes[static_cast<std::size_t>(page.series)];
    return page.landscape ? size : glm::dvec2{size.y, size.x};
}

SheetPage pageOfSeries(int series) noexcept { return {series, series < smallestSeries}; }

std::string nameOf(const SheetPage& page) {
    const std::string name = fmt::format("A{}", page.series);
    if (page == pageOfSeries(page.series)) return name;
    return name + (page.landscape ? "-landscape" : "-portrait");
}

Rect framed(const SheetPage& page) noexcept { return {{20.0, 10.0}, sizeOf(page) - 10.0}; }

Rect titleBlock(const SheetPage& page) noexcept {
    const glm::dvec2 corner = framed(page).high;
    return {corner - glm::dvec2{180.0, 24.0}, corner};
}

double wideLine(const SheetPage& page) noexcept { return page.series <= 1 ? 0.7 : 0.5; }

}  // namespace inkedge::sheet
