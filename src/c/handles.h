#pragma once

#include <exception>
#include <mutex>
#include <new>
#include <stop_token>
#include <string>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/error.h>
#include <inkedge/lines.h>
#include <inkedge/maps.h>
#include <inkedge/renderer.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "c/inkedge.h"

// What the handles of C stand for.

struct inkedge_settings {
    inkedge::Settings value;
    std::string text;  // that inkedge_get() gave last
};

struct inkedge_scene {
    inkedge::Scene value;
};

struct inkedge_camera {
    inkedge::Camera value;
};

struct inkedge_renderer {
    inkedge::Renderer value;
    std::mutex stopping;
    std::stop_source stop;  // of the call that it is in
};

struct inkedge_maps {
    inkedge::Maps value;
    std::vector<inkedge::Map> asked;
    std::string metadata;
};

struct inkedge_lines {
    inkedge::Lines value;
};

namespace inkedge::c {

/// Keeps the message for inkedge_message().
inkedge_status fail(Error::Kind, const std::string& message) noexcept;

/// Calls a function, none of whose exceptions leaves it.
template <class Function>
inkedge_status guarded(Function function) noexcept {
    try {
        function();
        return INKEDGE_OK;
    } catch (const Error& error) {
        return fail(error.kind(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(Error::Kind::Runtime, "expected enough memory, found too little; use a smaller model or size");
    } catch (const std::exception& error) {
        return fail(Error::Kind::Runtime, error.what());
    }
}

/// Makes what is handed out; until then, and if that fails, it is null.
template <class Handle, class Make>
inkedge_status handOut(Handle** handle, Make make) noexcept {
    return guarded([&] {
        if (handle == nullptr) throw Error{Error::Kind::Usage, "expected a pointer for what is made, found NULL"};
        *handle = nullptr;
        *handle = make();
    });
}

/// @throws Error  (Kind::Usage) if it is null
template <class T>
T& given(T* pointer, const char* name) {
    if (pointer == nullptr) throw Error{Error::Kind::Usage, std::string{name} + ": expected one, found NULL"};
    return *pointer;
}

/// The defaults if it is null.
[[nodiscard]] inline Settings valueOf(const inkedge_settings* settings) {
    return settings == nullptr ? Settings{} : settings->value;
}

}  // namespace inkedge::c
