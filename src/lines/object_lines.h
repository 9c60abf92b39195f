#pragma once

#include <memory>

#include <inkedge/lines.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/find/contours.h"

namespace inkedge::lines {

/// The types of lines that no pixels show.
inline constexpr LineTypes typesBesidePixels = formLineTypes | LineType::Marked | LineType::Tangent;
/// Those of them that Maps::types and Maps::edges have.
inline constexpr LineTypes typesAddedToMaps = typesBesidePixels - LineType::Marked;

/// The lines of a scene from object space. Edge tables and bounding volume hierarchies are made once for all views, and
/// once for all objects of one scene that exist at the same time, on whatever threads. What ContourFinder::Random
/// remembers of earlier views is each object's own.
class ObjectLines {
public:
    /// @throws Error  (Kind::Runtime) if Embree is not there or runs out of memory; (Kind::Stopped) as stopIfAsked()
    explicit ObjectLines(const Scene&);
    ~ObjectLines();

    [[nodiscard]] bool holds(const Scene&) const noexcept;

    /// The lines that a camera sees and, if settings.lines.hidden asks for them, those hidden from it: section 3 of
    /// Hertzmann 1999.
    [[nodiscard]] Lines find(const Camera&, const RenderSettings&) const;
    /// Those of typesBesidePixels, but for marked creases that are drawn as creases: what image space lacks.
    [[nodiscard]] Lines findBesidePixels(const Camera&, const RenderSettings&) const;

private:
    struct Prepared;
    struct Memories;
    [[nodiscard]] Lines find(const Camera&, const RenderSettings&, MarkedCreases) const;
    std::shared_ptr<const Prepared> prepared_;
    std::unique_ptr<Memories> memories_;
};

}  // namespace inkedge::lines
