#pragma once

#include <memory>

#include <inkedge/lines.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/see/view_buffers.h"

namespace inkedge::lines {

/// A scene made ready for its lines: edge tables and bounding volume hierarchies, made once for all views.
class ObjectLines {
public:
    /// @throws Error  (Kind::Runtime) if Embree is not there or runs out of memory
    explicit ObjectLines(const Scene&);
    ~ObjectLines();

    [[nodiscard]] bool holds(const Scene&) const noexcept;

    /// The lines that a camera sees and, if settings.lines.hidden asks for them, those hidden from it: section 3 of
    /// Hertzmann 1999.
    /// @param buffers  what the camera sees, of settings.picture.size: hidden lines are told by it, and by rays only
    ///                 where it leaves a doubt; null: by rays alone
    [[nodiscard]] Lines find(const Camera&, const RenderSettings&, const ViewBuffers* buffers = nullptr) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace inkedge::lines
