#include "python/renderers.h"

#include <mutex>
#include <optional>

#include <inkedge/renderer.h>

#include "python/arrays.h"
#include "python/cameras.h"
#include "python/documentation.h"
#include "python/keywords.h"
#include "python/lines.h"
#include "python/maps.h"
#include "python/released.h"

namespace inkedge::python {
namespace {

// A renderer until it is closed. Threads that call it wait for each other.
class OpenRenderer {
public:
    OpenRenderer(const BackendSettings& settings, ContextTime when) { renderer_.emplace(settings, when); }

    /// Calls a function with the renderer, while the GIL is released.
    template <class Function>
    auto with(Function function) {
        return released([&] {
            const std::unique_lock lock = base::lockUnlessStopped(using_);
            if (!renderer_) refuse("renderer: expected one that is open, found one that was closed");
            return function(*renderer_);
        });
    }

    void close() {
        released([&] {
            const std::scoped_lock lock{using_};
            renderer_.reset();
        });
    }

private:
    std::timed_mutex using_;
    std::optional<Renderer> renderer_;
};

std::unique_ptr<OpenRenderer> open(const py::object& backend, const py::object& device, bool lazy) {
    py::kwargs keywords;
    keywords["backend"] = backend;
    if (!device.is_none()) keywords["device"] = device;
    Settings settings;
    apply(settings, keywords, opening);
    return released([&] {
        return std::make_unique<OpenRenderer>(settings.backend, lazy ? ContextTime::WhenNeeded : ContextTime::AtOnce);
    });
}

DrawnMaps render(OpenRenderer& renderer, const Scene& scene, const CameraChoice& camera, bool writable,
                 const py::kwargs& keywords) {
    Settings settings;
    settings.maps = {Map::Types, Map::Depth, Map::Normal, Map::Ids};
    apply(settings, keywords, drawing);
    warnOfIdle(settings, {.pictures = true});
    Maps maps = renderer.with([&](Renderer& open) {
        const FramedView view = camera.lay(scene, settings);
        settings.picture = view.picture;
        return open.render(scene, view.camera, settings);
    });
    return drawnMaps(std::move(maps), settings.maps, writable);
}

DrawnLines lines(OpenRenderer& renderer, const Scene& scene, const CameraChoice& camera, const py::kwargs& keywords) {
    Settings settings;
    apply(settings, keywords, lining);
    warnOfIdle(settings, {.vectors = true, .dxf = true, .json = true});
    Lines found = renderer.with([&](Renderer& open) {
        const FramedView view = camera.lay(scene, settings);
        settings.picture = view.picture;
        return open.lines(scene, view.camera, settings);
    });
    return drawnLines(std::move(found), settings);
}

}  // namespace

void addRenderers(py::module_& module) {
    py::class_<OpenRenderer>(module, "Renderer", documentation::renderer)
        .def(py::init(&open), py::arg("backend") = "auto", py::arg("device") = py::none(), py::kw_only{},
             py::arg("lazy") = false)
        .def("__enter__", [](const py::object& self) { return self; })
        .def("__exit__", [](OpenRenderer& self, const py::args&) { self.close(); })
        .def("close", &OpenRenderer::close, "Gives up the context; what was drawn stays.")
        .def_property_readonly(
            "backend", [](OpenRenderer& self) { return self.with([](Renderer& open) { return open.backend(); }); })
        .def("render", render, py::arg("scene"), py::arg("camera"), py::kw_only{}, py::arg("writable") = false,
             documentation::render().c_str())
        .def("lines", lines, py::arg("scene"), py::arg("camera"), documentation::renderLines().c_str());
}

}  // namespace inkedge::python
