#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace inkedge::mesh {

/// Smooths values at points of a surface as heat spreads: one step of backward Euler of the heat equation, with the
/// cotangents of the faces' angles as the conductances of edges (Desbrun et al. 1999). Values far apart are mixed as by
/// a kernel of a given variance, however the mesh divides the surface; edges much longer than that mix nothing.
class HeatSmoothing {
public:
    /// An edge between two points, and half the sum of the cotangents of the angles opposite it.
    struct Edge {
        std::uint32_t a;
        std::uint32_t b;
        double conductance;
    };

    /// @param areas     one per point: its share of the surface's area
    /// @param variance  of the kernel along each axis, in the unit of the areas
    HeatSmoothing(const std::vector<Edge>&, const std::vector<double>& areas, double variance);

    /// The values become smoothed ones, within about a hundredth of their range. The same on any number of threads.
    template <std::size_t n>
    void smooth(std::vector<std::array<float, n>>& values) const;

private:
    struct Neighbour {
        std::uint32_t point;
        float weight;  // the weights of a point's neighbours and its own make 1
    };
    std::vector<std::uint32_t> begins_;  // one per point, and the end
    std::vector<Neighbour> neighbours_;
    std::vector<float> own_;  // one per point: the weight of its value before
    double radius_ = 0.0;     // of nearly all eigenvalues of the neighbours' weights
};

}  // namespace inkedge::mesh
