#include "ink/free_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "settings/pens.h"

namespace inkedge::ink {
namespace {

constexpr double touching = 0.5;     // pixels
constexpr double near = 1.5;         // pixels: within this a line that goes on may begin
constexpr double nearInSpace = 4.0;  // pixels across at the end
constexpr double smoothly = 0.7;     // cosine
constexpr double asOne = 0.9;        // cosine
constexpr double ownStep = 2.0;      // pixels of a line over which its direction is taken
constexpr double ownWay = 6.0;       // pixels along a line from its end: this part of the line is the end itself
constexpr double rowHeight = 16.0;   // pixels
constexpr double rowsBeyond = 4.0;   // rows above and below the picture: strokes may begin there and reach into it

struct End {
    LinePoint point;
    std::size_t line;
    bool last;           // of the line's points; else the first
    glm::dvec2 outward;  // unit, or 0
    double reach;        // world length
    bool joined = false;
};

std::pair<double, double> rowAndX(const End& end) {
    return {std::floor(end.point.pixel.y / rowHeight), end.point.pixel.x};
}

// The point between a and b that is nearest to p, as a share of the way from a to b.
template <class Vector>
double nearestShare(Vector p, Vector a, Vector b) {
    const Vector along = b - a;
    const double square = glm::dot(along, along);
    return square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
}

template <class Vector>
double distanceTo(Vector p, Vector a, Vector b) {
    return glm::distance(p, glm::mix(a, b, nearestShare(p, a, b)));
}

// A straight piece of a line. Lengths are measured along the line from its first point: to both ends of the piece, and
// to the last point of the line.
struct Piece {
    std::size_t line;
    const LinePoint& a;
    const LinePoint& b;
    double begin;
    double end;
    double whole;
    bool closed;
};

// How the line of a piece runs where it is nearest to an end.
struct Course {
    double cosine;  // between the line and the direction of the end: 0 to 1
    double ahead;   // pixels that the line still has in that direction
};

Course courseOf(const End& end, const Piece& piece, double way) {
    const glm::dvec2 along = piece.b.pixel - piece.a.pixel;
    const double length = glm::length(along);
    const double cosine = length > 0.0 ? glm::dot(along, end.outward) / length : 0.0;
    if (piece.closed) return {std::abs(cosine), std::numeric_limits<double>::infinity()};
    return {std::abs(cosine), cosine > 0.0 ? piece.whole - way : way};
}

bool meets(const End& end, const Piece& piece) {
    const glm::dvec2 pixel = end.point.pixel;
    const double distance = distanceTo(pixel, piece.a.pixel, piece.b.pixel);
    if (distance > near) return false;
    const double way = glm::mix(piece.begin, piece.end, nearestShare(pixel, piece.a.pixel, piece.b.pixel));
    if (end.line == piece.line && (end.last ? piece.whole - way : way) <= ownWay) return false;
    const Course course = courseOf(end, piece, way);
    const bool endsToo = course.cosine > asOne && course.ahead <= near;  // both lines run out in one tip
    const bool goesOn = course.cosine > smoothly && course.ahead > near;
    const bool touches =
        distance <= touching && distanceTo(end.point.position, piece.a.position, piece.b.position) <= end.reach;
    return goesOn || (touches && !endsToo);
}

// Ends of lines, sorted by rows of the picture, and from left to right in each row.
class EndRows {
public:
    EndRows(std::vector<End> ends, Size size)
        : ends_{std::move(ends)}, lastRow_{std::floor(size.height / rowHeight) + rowsBeyond} {
        std::ranges::sort(ends_, {}, rowAndX);
    }

    void join(const Piece& piece) {
        const glm::dvec2 a = piece.a.pixel;
        const glm::dvec2 b = piece.b.pixel;
        const double low = std::min(a.y, b.y) - near;
        const double high = std::max(a.y, b.y) + near;
        if (!std::isfinite(low + high)) return;
        const double last = std::min(std::floor(high / rowHeight), lastRow_);
        for (double row = std::max(std::floor(low / rowHeight), -rowsBeyond); row <= last; ++row) {
            double from = a.x;  // where the piece is in the row
            double to = b.x;
            if (a.y != b.y) {
                const auto xAt = [&](double y) {
                    return glm::mix(a.x, b.x, std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0));
                };
                from = xAt(row * rowHeight - near);
                to = xAt((row + 1.0) * rowHeight + near);
            }
            const auto begin = std::ranges::lower_bound(ends_, std::pair{row, std::min(from, to) - near}, {}, rowAndX);
            for (auto end = begin; end != ends_.end() && rowAndX(*end) <= std::pair{row, std::max(from, to) + near};
                 ++end)
                end->joined = end->joined || meets(*end, piece);
        }
    }

    [[nodiscard]] const std::vector<End>& ends() const noexcept { return ends_; }

private:
    std::vector<End> ends_;
    double lastRow_;
};

double footprint(const Lines& lines, glm::dvec3 point) {
    const double focalLength = lines.camera.focalLength(lines.size);
    const double depth = -(lines.camera.view * glm::dvec4{point, 1.0}).z;
    return (lines.camera.orthographic() ? 1.0 : std::max(depth, 0.0)) / focalLength;
}

glm::dvec2 outward(const Line& line, bool last) {
    const auto at = [&](std::size_t i) { return line.points[last ? line.points.size() - 1 - i : i].pixel; };
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const glm::dvec2 along = at(0) - at(i);
        const double length = glm::length(along);
        if (length >= ownStep || (i + 1 == line.points.size() && length > 0.0)) return along / length;
    }
    return {0.0, 0.0};
}

std::vector<End> endsOf(const Lines& lines, const PictureSettings& picture, const LineSettings& settings) {
    std::vector<End> ends;
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const Line& line = lines.lines[i];
        if (line.closed || line.points.empty() || !settings::isDrawn(line, picture, settings)) continue;
        for (const bool last : {false, true}) {
            const LinePoint& point = last ? line.points.back() : line.points.front();
            if (std::isfinite(point.pixel.x) && std::isfinite(point.pixel.y))
                ends.push_back({point, i, last, outward(line, last), nearInSpace * footprint(lines, point.position)});
        }
    }
    return ends;
}

auto order(const LinePoint& p) { return std::tuple{p.pixel.x, p.pixel.y, p.position.x, p.position.y, p.position.z}; }

}  // namespace

FreeEnds::FreeEnds(const Lines& lines, const PictureSettings& picture, const LineSettings& settings) {
    EndRows rows{endsOf(lines, picture, settings), lines.size};
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const Line& line = lines.lines[i];
        if (!settings::isDrawn(line, picture, settings)) continue;
        std::vector<double> ways{0.0};
        for (std::size_t k = 1; k < line.points.size(); ++k)
            ways.push_back(ways.back() + glm::distance(line.points[k - 1].pixel, line.points[k].pixel));
        for (std::size_t k = 1; k < line.points.size(); ++k)
            rows.join({i, line.points[k - 1], line.points[k], ways[k - 1], ways[k], ways.back(), line.closed});
        if (line.closed) rows.join({i, line.points.back(), line.points.front(), 0.0, 0.0, 0.0, true});
    }
    for (const End& end : rows.ends())
        if (end.joined) joined_.push_back(end.point);
    std::ranges::sort(joined_, {}, order);
}

bool FreeEnds::has(const LinePoint& end) const { return !std::ranges::binary_search(joined_, order(end), {}, order); }

}  // namespace inkedge::ink
