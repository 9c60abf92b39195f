#include "mesh/opensubdiv_limit.h"

#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/opensubdiv_refiner.h"

namespace inkedge::mesh {
namespace {

namespace Bfr = OpenSubdiv::Bfr;

// The part of the limit surface that a face controls.
class FacePatch {
public:
    FacePatch(const Bfr::SurfaceFactory& factory, int face, std::span<const glm::dvec3> positions) {
        if (!factory.InitVertexSurface(face, &surface_)) return;
        points_.resize(static_cast<std::size_t>(surface_.GetNumPatchPoints()));
        surface_.PreparePatchPoints(&positions.front().x, 3, &points_.front().x, 3);
    }

    [[nodiscard]] SurfaceDerivatives at(std::uint32_t quad, glm::dvec2 uv) const {
        if (!surface_.IsValid()) return {};
        const Bfr::Parameterization parameters = surface_.GetParameterization();
        const glm::dvec2 own = clamped(uv, parameters.GetType() == Bfr::Parameterization::TRI);
        glm::dvec2 inFace = own;
        if (parameters.HasSubFaces())
            parameters.ConvertNormalizedSubFaceToCoord(static_cast<int>(quad), &own.x, &inFace.x);
        SurfaceDerivatives d = evaluate(inFace);
        if (parameters.GetType() == Bfr::Parameterization::TRI && !surface_.IsRegular()) mendSigns(inFace, d);
        if (parameters.HasSubFaces()) halve(d);
        return continued(d, uv - own);
    }

private:
    static glm::dvec2 clamped(glm::dvec2 uv, bool isTriangle) {
        uv = glm::clamp(uv, 0.0, 1.0);
        if (const double over = uv.x + uv.y - 1.0; isTriangle && over > 0.0) uv = glm::clamp(uv - 0.5 * over, 0.0, 1.0);
        return uv;
    }

    [[nodiscard]] SurfaceDerivatives evaluate(glm::dvec2 uv) const {
        SurfaceDerivatives d;
        surface_.Evaluate(&uv.x, &points_.front().x, 3, &d.position.x, &d.du.x, &d.dv.x, &d.duu.x, &d.duv.x, &d.dvv.x);
        return d;
    }

    // In OpenSubdiv 3.5 the second derivatives on triangles that refinement turns about have the wrong sign.
    void mendSigns(glm::dvec2 uv, SurfaceDerivatives& d) const {
        constexpr double share = 1e-4;
        const glm::dvec2 step = share * (glm::dvec2{1.0 / 3.0} - uv);
        const SurfaceDerivatives other = evaluate(uv + step);
        const double agreement = glm::dot(step.x * d.duu + step.y * d.duv, other.du - d.du) +
                                 glm::dot(step.x * d.duv + step.y * d.dvv, other.dv - d.dv);
        if (agreement >= 0.0) return;
        for (glm::dvec3* const second : {&d.duu, &d.duv, &d.dvv}) *second = -*second;
    }

    // The quads of a polygon have half as long parameters in OpenSubdiv.
    static void halve(SurfaceDerivatives& d) {
        for (glm::dvec3* const first : {&d.du, &d.dv}) *first *= 0.5;
        for (glm::dvec3* const second : {&d.duu, &d.duv, &d.dvv}) *second *= 0.25;
    }

    static SurfaceDerivatives continued(SurfaceDerivatives d, glm::dvec2 by) {
        d.position +=
            by.x * d.du + by.y * d.dv + 0.5 * (by.x * by.x * d.duu + 2.0 * by.x * by.y * d.duv + by.y * by.y * d.dvv);
        d.du += by.x * d.duu + by.y * d.duv;
        d.dv += by.x * d.duv + by.y * d.dvv;
        return d;
    }

    Bfr::Surface<double> surface_;
    std::vector<glm::dvec3> points_;
};

// Faces' patches are made when they are first asked for.
class OpenSubdivLimit final : public LimitSurface {
public:
    explicit OpenSubdivLimit(const ControlMesh& control)
        : refiner_{makeRefiner(control)}, factory_{*refiner_, options()}, positions_{control.positions} {}

    [[nodiscard]] SurfaceDerivatives at(std::uint32_t face, std::uint32_t quad, glm::dvec2 uv) const override {
        return patchOf(face).at(quad, uv);
    }

private:
    // Near points where other than the usual number of faces meet patches are approximate, from so many levels on.
    static Bfr::SurfaceFactory::Options options() {
        constexpr int levels = 10;  // with more OpenSubdiv 3.5 crashes
        return Bfr::SurfaceFactory::Options{}.SetApproxLevelSmooth(levels).SetApproxLevelSharp(levels);
    }

    const FacePatch& patchOf(std::uint32_t face) const {
        const std::scoped_lock lock{mutex_};
        std::unique_ptr<const FacePatch>& patch = patches_[face];
        if (!patch) patch = std::make_unique<const FacePatch>(factory_, static_cast<int>(face), positions_);
        return *patch;
    }

    Refiner refiner_;
    Bfr::RefinerSurfaceFactory<> factory_;
    std::vector<glm::dvec3> positions_;
    mutable std::mutex mutex_;
    mutable std::unordered_map<std::uint32_t, std::unique_ptr<const FacePatch>> patches_;
};

}  // namespace

std::shared_ptr<const LimitSurface> limitSurface(const ControlMesh& control) {
    return std::make_shared<const OpenSubdivLimit>(control);
}

}  // namespace inkedge::mesh
