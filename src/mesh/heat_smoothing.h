#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace inkedge::mesh {

/// Smooths values at points of a surface as heat spreads on it, with the cotangents of the faces' angles as the
/// conductances of edges (Desbrun et al. 1999): values are mixed as by a Gaussian, however the mesh divides the
/// surface.
class HeatSmoothing {
public:
    /// An edge between two points, and half the sum of the cotangents of the angles opposite it.
    struct Edge {
        std::uint32_t a;
        std::uint32_t b;
        double conductance;
    };

    /// @param areas  one per point: its share of the surface's area
    HeatSmoothing(const std::vector<Edge>&, const std::vector<double>& areas);

    /// The values become smoothed ones. The same on any number of threads.
    /// @param variance  of the Gaussian along each axis, in the unit of the areas
    /// O(n) sweeps over the values, for a Gaussian n edges wide.
    template <std::size_t n>
    void smooth(std::vector<std::array<float, n>>& values, double variance) const;

private:
    struct Neighbour {
        std::uint32_t point;
        float rate;  // at which a difference to it evens out
    };
    std::vector<std::uint32_t> begins_;  // one per point, and the end
    std::vector<Neighbour> neighbours_;
    double maxRate_ = 0.0;  // no difference evens out faster
};

}  // namespace inkedge::mesh
