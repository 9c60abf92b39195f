#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include <inkedge/backends.h>
#include <inkedge/camera.h>
#include <inkedge/error.h>
#include <inkedge/export.h>
#include <inkedge/lines.h>
#include <inkedge/maps.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge {

/// When a Renderer makes its context.
enum class ContextTime {
    AtOnce,     ///< in its constructor
    Meanwhile,  ///< in a thread of its own, while the caller loads a scene, say; as WhenNeeded where memory is limited
    /// In the first call that draws with it. Lines from object space, and pictures of them alone, without maps and
    /// functions, need no OpenGL on the machine.
    WhenNeeded
};

/// What these settings ask for and the scene has nothing for, one line each: isoparametric lines where no mesh has
/// texture coordinates. Known before anything is drawn; Maps::warnings and Lines::warnings have it, too.
[[nodiscard]] INKEDGE_API std::vector<std::string> renderWarnings(const Scene&, const RenderSettings&);

/// Owns one offscreen OpenGL context and draws any number of scenes and views with it.
///
/// One thread at a time may use a renderer; several renderers may work side by side. The context is current only during
/// a call. After the call the caller's EGL context is current again, if the renderer's context is EGL's too. Where one
/// Mesa serves both EGL and OSMesa, and the caller's context is of the other of the two, no context is current.
///
/// A call may be stopped from another thread by its token, which is looked at between tiles, stages and pieces of what
/// works without OpenGL. The call then throws Error (Kind::Stopped), and the renderer is as usable as before. What
/// OpenGL draws of one tile is waited for: a smaller PictureSettings::tileSize stops sooner.
///
/// A fork of a process that has drawn cannot: the driver's threads do not live on in it. What draws throws Error
/// (Kind::Runtime) there. A process may fork before it draws, and start programs at any time.
class INKEDGE_API Renderer {
public:
    /// @throws Error  (Kind::Context) if no context can be had; the message says why for each backend tried;
    ///                (Kind::Usage) if the settings name a device that is not there. Unless it is made at once the
    ///                call that needs the context throws, not the constructor.
    explicit Renderer(const BackendSettings& = {}, ContextTime = ContextTime::AtOnce);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws one view: the picture and the maps that settings.maps names. What is larger than settings.picture.tileSize
    /// is drawn in parts, so that graphics memory does not limit the size; the picture and the maps themselves are held
    /// in memory. A brush of lines from object space is held to the limits that the scene was loaded with. The upload
    /// of the last scene and the last brush are kept for the next call.
    /// @throws Error  (Kind::Usage) if validate() refuses a setting, or the camera is unusable;
    ///                (Kind::Input) if the brush of lines from object space cannot be read, or is no PNG;
    ///                (Kind::Runtime) if there is less memory than the picture and its maps take, or the context runs
    ///                out of memory, or is lost: then make a new Renderer
    [[nodiscard]] Maps render(const Scene&, const Camera&, const RenderSettings& = {}, const std::stop_token& = {});

    /// The lines of one view as polylines in the picture and in the world. From object space, unless
    /// settings.lines.from says image: visible ones, and hidden ones if settings.lines.hidden keeps them. What a scene
    /// needs for it (edge tables, bounding volume hierarchies) is kept for the next call. From image: what the planes
    /// detector finds between pixels. Of settings.picture, size, lines and, from image, pens, supersampling and
    /// tileSize are looked at. Lines::shade is drawn if settings.shade asks for it; that needs a context.
    /// @throws Error  (Kind::Usage) if validate() refuses a setting, if the camera is unusable, or lines from image are
    ///                asked of the classic detector, or of a contour finder what it cannot do; (Kind::Runtime) if
    ///                Embree is not there or memory runs out
    [[nodiscard]] Lines lines(const Scene&, const Camera&, const RenderSettings& = {}, const std::stop_token& = {});

    /// Empty while there is no context.
    [[nodiscard]] const BackendInfo& backend() const noexcept;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace inkedge
