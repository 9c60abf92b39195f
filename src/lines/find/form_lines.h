#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/find/contour_finders.h"
#include "lines/screen.h"
#include "lines/segment.h"
#include "mesh/surface_form.h"

namespace inkedge::lines {

/// Which lines of form to find.
struct FormChoice {
    LineTypes types;  ///< of formLineTypes
    FormSettings settings;
    HiddenLines hidden = HiddenLines::None;
    bool eyeOutside = true;  ///< as CurveChoice::eyeOutside
};

/// Adds the lines of form of one instance.
///
/// A suggestive contour is where the radial curvature is 0 and grows towards the eye (DeCarlo et al. 2003). A ridge is
/// where the greater principal curvature, if it is the stronger one, has a maximum in its own direction, and a valley
/// the same of the surface turned over (Ohtake et al. 2004), which one that is not closed is if it is seen from
/// behind. An apparent ridge is where the curvature that the eye sees
/// has a maximum in the direction in which it is seen (Judd et al. 2007).
///
/// They cross faces where a value that is linear within each is 0. A line stays if it is stronger somewhere than the
/// threshold, and then goes on where it is over half of that; and if it is longer than minFormLength.
void addFormLines(const Scene&, std::uint32_t instance, const mesh::SurfaceForm&, const MeshEdges&, const Screen&,
                  const FormChoice&, std::vector<Segment>& to);

inline constexpr double minFormLength = 4.0;  ///< SurfaceForm::resolutions
/// Of a threshold: what a line goes on over; and where its strength is 1, LinePoint::strength.
inline constexpr double weakestForm = 0.5;
inline constexpr double fullForm = 2.0;

}  // namespace inkedge::lines
