#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <inkedge/image.h>

#include "ink/stroke.h"

namespace inkedge::ink {

inline constexpr float halfDiagonal = 0.70711F;  // of a pixel
inline constexpr float shortestOffset = 1e-4F;   // pixels: a shorter offset has no reliable direction

/// The share of a pixel's square that a band of one width and direction covers.
class BandShare {
public:
    /// @param normal  across the band, unit
    /// @param width   pixels
    BandShare(glm::vec2 normal, float width);

    /// The exact share.
    /// @param distance  pixels, of the band's centre line from the pixel's centre
    /// @return          0 to 1
    [[nodiscard]] float at(float distance) const;

private:
    [[nodiscard]] float beside(float distance) const;

    float halfWidth_;
    float longer_;  // the larger component of the normal
    float even_;    // up to this distance a line cuts two opposite sides of the square
    float end_;     // from this distance on it cuts none
    float corner_;
};

/// Pixels from (x0, y0) to (x1, y1), both included; none if x1 < x0 or y1 < y0.
struct PixelBox {
    int x0;
    int y0;
    int x1;
    int y1;
};

/// The widths of a stroke at its ends, pixels.
struct EndWidths {
    float from;
    float to;
};
[[nodiscard]] EndWidths widthsOf(const Stroke&, float penWidth);

/// A stroke, the width of its pen and its pixels.
struct BoxedStroke {
    const Stroke* stroke;
    float width;   ///< of its pen, pixels
    PixelBox box;  ///< the pixels of the picture that the stroke may cover
};
[[nodiscard]] BoxedStroke boxed(const Stroke&, float penWidth, Size picture);

/// Some rows of a picture.
struct Rows {
    int first;
    int count;
};
[[nodiscard]] inline PixelBox boxIn(Rows rows, PixelBox box) {
    return {box.x0, std::max(box.y0, rows.first), box.x1, std::min(box.y1, rows.first + rows.count - 1)};
}

/// The centre line of a stroke. Points along it have measures from 0, at the start, to end.
struct CentreLine {
    glm::vec2 start;
    glm::vec2 step;     ///< from a point to the point whose measure is larger by 1
    glm::vec2 measure;  ///< the dot product of this and a point, less the start, is the point's measure
    float end;
    glm::vec2 normal;  ///< unit
};
[[nodiscard]] CentreLine measuredInShares(const Stroke&);  ///< the end's measure is 1; without length all are 0
[[nodiscard]] CentreLine measuredInPixels(const Stroke&);

/// A pixel near a centre line.
struct NearPixel {
    glm::vec2 centre;       ///< of the pixel, from the line's start
    float along;            ///< the measure of the pixel's centre
    float nearest;          ///< the measure of the line's point that is nearest to the centre
    glm::vec2 offset;       ///< from that point to the centre
    float distanceSquared;  ///< the square of the offset's length

    [[nodiscard]] bool isBeside(const CentreLine& line, float distance) const {  // not at a cap
        return (along > 0.0F && along < line.end) || distance < shortestOffset;
    }
    [[nodiscard]] glm::vec2 across(const CentreLine& line, float distance) const {
        return isBeside(line, distance) ? line.normal : offset / distance;
    }
};

/// Calls take(coverage, x, y, NearPixel) for the pixels of a stroke's box in some rows whose centres are nearer to its
/// centre line than reach.
/// @param coverage  of the rows
template <class Take>
void forEachNear(const CentreLine& line, float reach, Image<float>& coverage, Rows rows, PixelBox ofStroke,
                 Take&& take) {
    const PixelBox box = boxIn(rows, ofStroke);
    for (int y = box.y0; y <= box.y1; ++y) {
        float* const row = &coverage(0, y - rows.first);
        for (int x = box.x0; x <= box.x1; ++x) {
            const glm::vec2 centre = glm::vec2{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F} - line.start;
            const float along = glm::dot(centre, line.measure);
            const float nearest = std::clamp(along, 0.0F, line.end);
            const glm::vec2 offset = centre - nearest * line.step;
            const float distanceSquared = glm::dot(offset, offset);
            if (distanceSquared >= reach * reach) continue;
            take(row[x], x, y, NearPixel{centre, along, nearest, offset, distanceSquared});
        }
    }
}

/// The maximum distance between a stroke's centre line and the centre of a pixel that it covers.
[[nodiscard]] inline float reachOf(float width) { return 0.5F * width + halfDiagonal; }

/// Raises coverage to that of a stroke: a band of its width around its centre line, with round caps.
/// @param coverage  of the rows, 0 to 1
void cover(Image<float>& coverage, Rows, const BoxedStroke&);

inline BandShare::BandShare(glm::vec2 normal, float width) : halfWidth_{0.5F * width} {
    const glm::vec2 across = glm::abs(normal);
    longer_ = std::max(across.x, across.y);
    const float shorter = std::min(across.x, across.y);
    even_ = 0.5F * (longer_ - shorter);
    end_ = 0.5F * (longer_ + shorter);
    corner_ = 2.0F * longer_ * shorter;
}

inline float BandShare::at(float distance) const {
    const float outer = halfWidth_ + distance;
    const float inner = halfWidth_ - distance;
    if (inner >= halfDiagonal) return 1.0F;
    if (inner <= -halfDiagonal) return 0.0F;
    return beside(inner) + beside(outer) - 1.0F;
}

// The share that lies on one side of a line. The distance from the centre is positive if the centre is on that side.
inline float BandShare::beside(float distance) const {
    const float t = std::abs(distance);
    float far = 1.0F;
    if (t <= even_) {
        far = 0.5F + t / longer_;
    } else if (t < end_) {
        far -= (end_ - t) * (end_ - t) / corner_;
    }
    return distance < 0.0F ? 1.0F - far : far;
}

}  // namespace inkedge::ink
