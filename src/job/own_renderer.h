#pragma once

#include <optional>

#include <inkedge/renderer.h>

namespace inkedge::job {

/// A worker's renderer, made when its first view comes, and anew for a job that asks for another backend.
class OwnRenderer {
public:
    Renderer& of(const BackendSettings& wanted, ContextTime when = ContextTime::WhenNeeded) {
        if (!renderer_ || wanted.backend != backend_.backend || wanted.device != backend_.device) {
            renderer_.reset();
            renderer_.emplace(wanted, when);
            backend_ = wanted;
        }
        return *renderer_;
    }
    /// Its context may be lost: the next view gets another.
    void giveUp() { renderer_.reset(); }

private:
    BackendSettings backend_;
    std::optional<Renderer> renderer_;
};

}  // namespace inkedge::job
