#pragma once

#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <inkedge/error.h>
#include <inkedge/renderer.h>

#include "gl/context.h"
#include "gl/gpu.h"

/// Tests that run once on every backend. A backend that this machine does not have is skipped, aloud; if the
/// environment variable INKEDGE_REQUIRE_BACKENDS names it ("egl,osmesa"), its tests fail instead.
namespace inkedge::gl_test {

/// A renderer, and a context and what passes draw with, for tests that look behind the renderer.
struct Equipment {
    explicit Equipment(Backend backend)
        : renderer{BackendSettings{backend, {}}}, context{gl::createContext({backend, {}})} {
        const gl::Current current{*context};
        gpu = std::make_unique<gl::Gpu>(context->api());
    }
    ~Equipment() {
        const gl::Current current{*context};
        gpu.reset();
    }
    Equipment(const Equipment&) = delete;
    Equipment& operator=(const Equipment&) = delete;

    Renderer renderer;
    std::unique_ptr<gl::Context> context;
    std::unique_ptr<gl::Gpu> gpu;
};

inline std::string backendName(Backend backend) { return backend == Backend::Egl ? "egl" : "osmesa"; }

inline std::string nameOfInstance(const testing::TestParamInfo<Backend>& instance) {
    return backendName(instance.param);
}

/// Every backend's equipment, made when first asked for and shared by the process; contexts end before the process
/// does.
class Backends : public testing::Environment {
public:
    /// Null where the backend is missing; why() then says why.
    Equipment* equipment(Backend backend) {
        const auto [entry, fresh] = made_.try_emplace(backend);
        if (fresh) {
            try {
                entry->second.equipment = std::make_unique<Equipment>(backend);
            } catch (const Error& error) {
                entry->second.why = error.what();
                std::fprintf(stderr, "\n*** SKIPPED: every test on backend %s: %s\n\n", backendName(backend).c_str(),
                             error.what());
            }
        }
        return entry->second.equipment.get();
    }
    [[nodiscard]] const std::string& why(Backend backend) const { return made_.at(backend).why; }

    void TearDown() override { made_.clear(); }

    static Backends& instance() {
        static auto* const backends =
            static_cast<Backends*>(testing::AddGlobalTestEnvironment(new Backends));  // owned by the test framework
        return *backends;
    }

private:
    struct Made {
        std::unique_ptr<Equipment> equipment;
        std::string why;
    };
    std::map<Backend, Made> made_;
};

inline bool required(Backend backend) {
    const char* list = std::getenv("INKEDGE_REQUIRE_BACKENDS");
    return list != nullptr &&
           ("," + std::string{list} + ",").find("," + backendName(backend) + ",") != std::string::npos;
}

/// Base of every suite of GL tests; INKEDGE_ON_EACH_BACKEND(Suite) makes one.
class OnEachBackend : public testing::TestWithParam<Backend> {
protected:
    void SetUp() override {
        equipment_ = Backends::instance().equipment(GetParam());
        if (equipment_ != nullptr) return;
        const std::string& why = Backends::instance().why(GetParam());
        if (required(GetParam())) FAIL() << "INKEDGE_REQUIRE_BACKENDS names " << backendName(GetParam()) << ": " << why;
        GTEST_SKIP() << "no backend " << backendName(GetParam()) << ": " << why;
    }

    // Renderer::render() throws on an OpenGL error; this catches those of tests that call OpenGL themselves.
    void TearDown() override {
        if (equipment_ == nullptr) return;
        const gl::Current current{*equipment_->context};
        EXPECT_EQ(equipment_->context->api().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }

    [[nodiscard]] Renderer& renderer() const { return equipment_->renderer; }
    [[nodiscard]] gl::Context& context() const { return *equipment_->context; }
    /// Of context(), which must be current: gl::Current current{context()}.
    [[nodiscard]] gl::Gpu& gpu() const { return *equipment_->gpu; }

private:
    Equipment* equipment_ = nullptr;
};

/// The classic detector's settings for a picture of this size, with these maps.
inline Settings classic(Size size, std::vector<Map> maps = {}) {
    Settings settings;
    settings.detector.detector = Detector::Classic;
    settings.picture.size = size;
    settings.maps = std::move(maps);
    return settings;
}

inline const std::vector<Map> classicMaps{Map::Depth, Map::Normal, Map::DepthEdges, Map::NormalEdges, Map::Edges};

inline Image<double> toDouble(const Image<float>& image) {
    Image<double> result{image.size(), image.channels()};
    std::copy(image.pixels().begin(), image.pixels().end(), result.mutablePixels().begin());
    return result;
}

}  // namespace inkedge::gl_test

/// Declares a suite for TEST_P.
#define INKEDGE_ON_EACH_BACKEND(Suite)                                                                          \
    class Suite : public inkedge::gl_test::OnEachBackend {};                                                    \
    INSTANTIATE_TEST_SUITE_P(Backends, Suite, testing::Values(inkedge::Backend::Egl, inkedge::Backend::Osmesa), \
                             inkedge::gl_test::nameOfInstance)
