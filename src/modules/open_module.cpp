#include "modules/open_module.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/thread_trial.h"

namespace fs = std::filesystem;

namespace inkedge::modules {
namespace {

/// The folder of the shared library, or of the program, that holds this code.
fs::path ownFolder() {
    Dl_info information{};
    link_map* map = nullptr;
    const auto here = reinterpret_cast<const void*>(&ownFolder);
    if (::dladdr1(here, &information, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) == 0) map = nullptr;
    // A program has an empty name in the link map; Dl_info gives it the unreliable argv[0].
    const bool library = map != nullptr && map->l_name != nullptr && *map->l_name != '\0';
    std::error_code error;
    const fs::path file = fs::canonical(library ? map->l_name : "/proc/self/exe", error);
    return error ? fs::path{"/"} : file.parent_path();  // never a relative path: code is loaded from here
}

/// The folders of modules, relative to the code that opens them.
std::array<fs::path, 3> moduleFolders() {
    const fs::path own = ownFolder();
    return {
        own / "inkedge",            // installed: lib/libinkedge.so, lib/inkedge/
        own,                        // build tree, the library: both in lib/
        own.parent_path() / "lib",  // build tree, a test: bin/ and lib/
    };
}

void expectThreads(const Module& module, Error::Kind failure) {
    const std::size_t wanted = module.threads == nullptr ? 0 : module.threads();
    const std::size_t found = base::startableThreads(wanted);
    if (found == wanted) return;
    throw Error{failure, fmt::format("{}: expected {} threads for {}, found that {} can be started; raise the limit "
                                     "(ulimit -u), end other processes, or {}",
                                     module.purpose, wanted, module.library, found, module.remedy)};
}

void* open(const Module& module, const fs::path& file, Error::Kind failure) {
    expectThreads(module, failure);
    void* const object = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = object == nullptr ? nullptr : ::dlsym(object, module.symbol);
    if (symbol == nullptr) {
        const char* const reason = ::dlerror();
        throw Error{failure,
                    fmt::format("{}: expected {} and {} that can be opened, found: {}; install {} or reinstall "
                                "inkedge, or {}",
                                module.purpose, module.library, file.string(),
                                reason == nullptr ? "no reason given" : reason, module.library, module.remedy)};
    }
    return symbol;
}

}  // namespace

void* openModule(const Module& module, Error::Kind failure) { return openModule(module, moduleFolders(), failure); }

namespace {

fs::path find(const Module& module, std::span<const fs::path> folders, Error::Kind failure) {
    std::vector<std::string> tried;
    for (const fs::path& folder : folders) {
        std::error_code ignored;
        if (fs::exists(folder / module.file, ignored)) return folder / module.file;
        if (std::find(tried.begin(), tried.end(), folder.string()) == tried.end()) tried.push_back(folder.string());
    }
    const std::string build = module.option.empty() ? "" : fmt::format(" built with {}=ON", module.option);
    throw Error{failure, fmt::format("{}: expected {} in one of {}, found none; reinstall inkedge{}, or {}",
                                     module.purpose, module.file, fmt::join(tried, ", "), build, module.remedy)};
}

}  // namespace

void* openModule(const Module& module, std::span<const fs::path> folders, Error::Kind failure) {
    return open(module, find(module, folders, failure), failure);
}

fs::path findModule(const Module& module, Error::Kind failure) { return find(module, moduleFolders(), failure); }

std::string failureToOpen(const Module& module) {
    try {
        static_cast<void>(openModule(module, Error::Kind::Runtime));
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace inkedge::modules
