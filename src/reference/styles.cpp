#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace inkedge::reference {
namespace {

template <class T>
const T& atBorder(const Image<T>& image, int x, int y, int channel) {
    return image(std::clamp(x, 0, image.size().width - 1), std::clamp(y, 0, image.size().height - 1), channel);
}

double smoothstep(double low, double high, double value) {
    const double x = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

// The facet that a sample sees.
struct Facet {
    double w = 0.0;
    glm::dvec2 slope{0.0};
    bool there = false;
    glm::dvec3 normal{0.0};  // unit, the camera's axes
};

class Facets {
public:
    Facets(const Image<float>& planes, double focalLength, bool orthographic)
        : planes_{planes}, focalLength_{focalLength}, orthographic_{orthographic} {}

    [[nodiscard]] Facet at(int x, int y) const {
        Facet facet;
        const auto value = [&](int channel) { return static_cast<double>(atBorder(planes_, x, y, channel)); };
        facet.w = value(0);
        facet.slope = {value(1), value(2)};
        facet.there = value(3) != 0.0;
        const glm::dvec2 fromCentre{x + 0.5 - 0.5 * planes_.size().width, y + 0.5 - 0.5 * planes_.size().height};
        const double towardsEye = orthographic_ ? 1.0 : facet.w - glm::dot(facet.slope, fromCentre);
        facet.normal =
            glm::normalize(glm::dvec3{-focalLength_ * facet.slope.x, focalLength_ * facet.slope.y, towardsEye});
        return facet;
    }

    // Whether one of two neighbours along an axis lies in front of the other: detectLines().
    [[nodiscard]] bool jump(const Facet& p, const Facet& q, int axis, int sign) const {
        const double gp = sign * p.slope[axis];
        const double gq = sign * q.slope[axis];
        const double rp = q.w - (p.w + gp);
        const double rq = p.w - (q.w - gq);
        const double k = orthographic_ ? focalLength_ : focalLength_ / std::max(p.w, q.w);
        const double smaller = std::min(std::abs(rp), std::abs(rq)) * k;
        return rp * rq < 0.0 && smaller > 1.0 + std::min(std::abs(gp), std::abs(gq)) * k;
    }

private:
    const Image<float>& planes_;
    double focalLength_;
    bool orthographic_;
};

double bendBetween(const Facet& p, const Facet& q) {
    return std::atan2(glm::length(glm::cross(p.normal, q.normal)), glm::dot(p.normal, q.normal));
}

double brightness(const Facet& facet) {
    return std::max(glm::dot(facet.normal, glm::normalize(glm::dvec3{-0.45, 0.6, 0.66})), 0.0);
}

// Whether each of the two samples beside a pair sees a facet of the pair.
bool goesOn(const Facet& besideP, const Facet& besideQ, const Facet& p, const Facet& q) {
    const double tolerance = 0.2 * bendBetween(p, q);
    return std::min(bendBetween(besideP, p), bendBetween(besideP, q)) < tolerance &&
           std::min(bendBetween(besideQ, p), bendBetween(besideQ, q)) < tolerance;
}

}  // namespace

Image<double> hatch(const Image<float>& planes, double focalLength, bool orthographic, double bend, double shade,
                    double width) {
    const Facets facets{planes, focalLength, orthographic};
    // How much the mark between the sample p at a pixel and the next sample q along an axis covers of the sample that
    // lies so many steps before p.
    const auto mark = [&](glm::ivec2 pixel, int axis, int sign, int before) {
        glm::ivec2 step{0};
        step[axis] = sign;
        const glm::ivec2 beside{step.y, step.x};
        const auto facetAt = [&](glm::ivec2 at) { return facets.at(at.x, at.y); };
        const Facet p = facetAt(pixel);
        const Facet q = facetAt(pixel + step);
        if (!p.there || !q.there || facets.jump(p, q, axis, sign)) return 0.0;
        if (!goesOn(facetAt(pixel + beside), facetAt(pixel + step + beside), p, q) &&
            !goesOn(facetAt(pixel - beside), facetAt(pixel + step - beside), p, q))
            return 0.0;
        const double light = 0.5 * (brightness(p) + brightness(q));
        const double dark = glm::radians(bend) * std::max(1.0 - shade + 3.0 * shade * std::pow(light, 1.5), 0.1);
        const glm::dvec2 slope = p.slope - q.slope;
        const double difference =
            p.w - (q.w - glm::dot(q.slope, glm::dvec2{step})) - before * glm::dot(slope, glm::dvec2{step});
        const double away = std::abs(difference) / std::max(glm::length(slope), 1e-30);
        return smoothstep(0.7 * dark, 1.3 * dark, bendBetween(p, q)) *
               std::clamp(std::min(0.5 + 0.5 * width - away, width), 0.0, 1.0);
    };
    Image<double> ink{planes.size(), 1};
    for (int y = 0; y < planes.size().height; ++y) {
        for (int x = 0; x < planes.size().width; ++x) {
            const Facet p = facets.at(x, y);
            if (!p.there) continue;
            for (const int axis : {0, 1}) {
                for (const int sign : {1, -1}) {
                    glm::ivec2 step{0};
                    step[axis] = sign;
                    const glm::ivec2 pixel{x, y};
                    const Facet q = facets.at(x + step.x, y + step.y);
                    const Facet r = facets.at(x + 2 * step.x, y + 2 * step.y);
                    if (!q.there || facets.jump(p, q, axis, sign)) continue;
                    ink(x, y) = std::max(ink(x, y), mark(pixel, axis, sign, 0));
                    if (bendBetween(p, q) < 0.5 * bendBetween(q, r))
                        ink(x, y) = std::max(ink(x, y), mark(pixel + step, axis, sign, 1));
                }
            }
        }
    }
    return ink;
}

namespace {

Image<double> blurred(const Image<double>& image, double sigma) {
    const int radius = static_cast<int>(std::ceil(2.5 * sigma));
    const auto weight = [&](int away) { return std::exp(-0.5 * away * away / (sigma * sigma)); };
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) sum += weight(i);
    Image<double> result = image;
    for (const glm::ivec2 along : {glm::ivec2{1, 0}, glm::ivec2{0, 1}}) {
        const Image<double> source = result;
        for (int y = 0; y < image.size().height; ++y) {
            for (int x = 0; x < image.size().width; ++x) {
                for (int c = 0; c < image.channels(); ++c) {
                    double value = 0.0;
                    for (int i = -radius; i <= radius; ++i)
                        value += weight(i) / sum * atBorder(source, x + i * along.x, y + i * along.y, c);
                    result(x, y, c) = value;
                }
            }
        }
    }
    return result;
}

// Derivatives of one channel by the Sobel kernels, in units in which a blurred step of 1 has derivative 1.
glm::dvec2 gradient(const Image<double>& image, int x, int y, int channel, double sigma) {
    glm::dvec2 sum{0.0};
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const double value = atBorder(image, x + i, y + j, channel);
            sum.x += sobelDerivative[i + 1] * sobelSmoothing[j + 1] * value;
            sum.y += sobelSmoothing[i + 1] * sobelDerivative[j + 1] * value;
        }
    }
    return sum * std::sqrt(2.0 * std::numbers::pi * (sigma * sigma + 0.5)) / 8.0;
}

// The unit vector across the major axis of a structure tensor, given as xx, yy, xy; 0 if the tensor has no axis.
glm::dvec2 tangentOf(glm::dvec3 tensor) {
    if (tensor.x == tensor.y && tensor.z == 0.0) return glm::dvec2{0.0};
    const double angle = 0.5 * std::atan2(2.0 * tensor.z, tensor.x - tensor.y);
    return {-std::sin(angle), std::cos(angle)};
}

}  // namespace

Image<double> sumi(const Image<double>& depth, const Image<double>& normal, const Camera& camera,
                   const StyleSettings& settings) {
    const Image<double> scaled = scaledDepth(depth, camera, DepthMap::Linear);
    const auto [width, height] = depth.size();
    Image<double> channels{depth.size(), 4};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double d = scaled(x, y);
            if (settings.sumiStreaks > 0) d = std::floor(d * settings.sumiStreaks) / settings.sumiStreaks;
            if (normal(x, y, 0) == 0.0 && normal(x, y, 1) == 0.0 && normal(x, y, 2) == 0.0) d = 1.0;
            for (int c = 0; c < 3; ++c) channels(x, y, c) = normal(x, y, c) / 0.5;
            channels(x, y, 3) = d / 0.06;
        }
    }
    const double sigma = std::max(0.25 * settings.sumiWidth, 0.7);
    channels = blurred(channels, sigma);

    Image<double> tensors{depth.size(), 3};
    Image<double> taken{depth.size(), 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glm::dvec3 tensor{0.0};
            double magnitude = 0.0;
            for (int c = 0; c < 4; ++c) {
                const glm::dvec2 g = gradient(channels, x, y, c, sigma);
                tensor += glm::dvec3{g.x * g.x, g.y * g.y, g.x * g.y};
                magnitude = std::max(magnitude, glm::length(g));
            }
            for (int c = 0; c < 3; ++c) tensors(x, y, c) = tensor[c] / (1.0 + tensor.x + tensor.y);
            taken(x, y) = std::pow(magnitude, 1.5) / (1.0 + std::pow(magnitude, 1.5));
        }
    }
    tensors = blurred(tensors, std::max(0.5 * settings.sumiWidth, 2.0));

    const auto tangentAt = [&](int x, int y) {
        return tangentOf({tensors(x, y, 0), tensors(x, y, 1), tensors(x, y, 2)});
    };
    const int steps = static_cast<int>(std::lround(settings.sumiLength));
    const double spread = std::max(0.5 * steps, 1.0);
    Image<double> ink{depth.size(), 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double sum = taken(x, y);
            double weights = 1.0;
            for (const double way : {1.0, -1.0}) {
                glm::dvec2 pixel{x + 0.5, y + 0.5};
                glm::dvec2 direction = way * tangentAt(x, y);
                for (int i = 1; i <= steps; ++i) {
                    pixel += direction;
                    const int px = std::clamp(static_cast<int>(std::floor(pixel.x)), 0, width - 1);
                    const int py = std::clamp(static_cast<int>(std::floor(pixel.y)), 0, height - 1);
                    const double weight = std::exp(-0.5 * i * i / (spread * spread));
                    sum += weight * taken(px, py);
                    weights += weight;
                    const glm::dvec2 tangent = tangentAt(px, py);
                    direction = glm::dot(tangent, direction) < 0.0 ? -tangent : tangent;
                }
            }
            ink(x, y) = sum / weights;
        }
    }
    return ink;
}

namespace {

// A number from 0 to 1 for a knot of a layer: finaliser after Wellons 2018, "triple32".
double chance(std::uint32_t x, std::uint32_t y, std::uint32_t layer) {
    std::uint32_t h = x * 0x9e3779b1U ^ y * 0x85ebca77U ^ layer * 0xc2b2ae3dU;
    h = (h ^ (h >> 17U)) * 0xed5ad4bbU;
    h = (h ^ (h >> 11U)) * 0xac4c1b51U;
    h = (h ^ (h >> 15U)) * 0x31848babU;
    return static_cast<double>((h ^ (h >> 14U)) >> 8U) / 16777216.0;
}

double noise(glm::dvec2 pixel, double cell, std::uint32_t layer) {
    const glm::dvec2 p = pixel / cell;
    const auto x = static_cast<std::uint32_t>(p.x);
    const auto y = static_cast<std::uint32_t>(p.y);
    const auto eased = [](double f) { return f * f * f * (f * (6.0 * f - 15.0) + 10.0); };
    const double u = eased(p.x - std::floor(p.x));
    const double v = eased(p.y - std::floor(p.y));
    return glm::mix(glm::mix(chance(x, y, layer), chance(x + 1, y, layer), u),
                    glm::mix(chance(x, y + 1, layer), chance(x + 1, y + 1, layer), u), v);
}

double stray(glm::dvec2 pixel, double cell, std::uint32_t layer) {
    return 2.0 * noise(pixel, cell, layer) - 1.0 + 0.3 * (2.0 * noise(pixel, cell / 3.0, layer + 1) - 1.0);
}

// The drawing between four pixels, premultiplied, 0 to 1.
glm::dvec4 inkAt(const Image<std::uint8_t>& drawing, glm::dvec2 pixel) {
    const glm::dvec2 corner = glm::floor(pixel - 0.5);
    const glm::dvec2 share = pixel - 0.5 - corner;
    const auto texel = [&](int i, int j) {
        glm::dvec4 t{0.0};
        for (int c = 0; c < 4; ++c)
            t[c] = atBorder(drawing, static_cast<int>(corner.x) + i, static_cast<int>(corner.y) + j, c) / 255.0;
        return glm::dvec4{glm::dvec3{t} * t.a, t.a};
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x), glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}

}  // namespace

Image<double> pencil(const Image<std::uint8_t>& drawing, const StyleSettings& settings) {
    const double cell = std::max(16.0 * settings.pencilLooseness, 24.0);
    Image<double> drawn{drawing.size(), 4};
    for (int y = 0; y < drawing.size().height; ++y) {
        for (int x = 0; x < drawing.size().width; ++x) {
            const glm::dvec2 pixel{x + 0.5, y + 0.5};
            const double grain = 0.6 * noise(pixel, 1.7, 0xfffffffeU) + 0.4 * noise(pixel, 3.1, 0xffffffffU);
            glm::dvec4 sum{0.0};  // premultiplied
            for (int i = 0; i < settings.pencilStrokes; ++i) {
                const auto layer = static_cast<std::uint32_t>(settings.pencilSeed * 16 + i) * 8;
                const glm::dvec2 away{stray(pixel, cell, layer), stray(pixel, cell, layer + 2)};
                const glm::dvec4 found = inkAt(drawing, pixel + 1.5 * settings.pencilLooseness * away);
                if (found.a == 0.0) continue;
                const double pressed = found.a * (0.5 + 0.5 * noise(pixel, 1.3 * cell, layer + 4));
                const double left = std::clamp((pressed - 0.6 * grain * (1.0 - pressed)) / 0.5, 0.0, 1.0) *
                                    std::min(0.35 + pressed, 1.0);
                const glm::dvec4 added = glm::dvec4{glm::dvec3{found} / found.a, 1.0} * (0.85 * left);
                sum = added + sum * (1.0 - added.a);
            }
            const glm::dvec4 color = sum.a > 0.0 ? glm::dvec4{glm::dvec3{sum} / sum.a, sum.a} : glm::dvec4{0.0};
            for (int c = 0; c < 4; ++c) drawn(x, y, c) = color[c];
        }
    }
    return drawn;
}

}  // namespace inkedge::reference
