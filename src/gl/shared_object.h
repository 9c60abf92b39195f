#pragma once

#include <dlfcn.h>

#include <initializer_list>

namespace inkedge::gl {

/// Opens a system library by the first of several names that works, without exporting its symbols; null if none does.
/// The library stays open until the process ends: drivers leave threads and exit handlers that must not outlive their
/// code.
inline void* openSharedObject(std::initializer_list<const char*> names) noexcept {
    for (const char* name : names) {
        if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) return handle;
    }
    return nullptr;
}

template <class Function>
bool resolve(void* sharedObject, const char* name, Function& function) noexcept {
    function = reinterpret_cast<Function>(dlsym(sharedObject, name));
    return function != nullptr;
}

}  // namespace inkedge::gl
