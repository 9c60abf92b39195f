#include "gl/context.h"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/thread_trial.h"

namespace inkedge {
namespace gl {
namespace {

constexpr int requiredVersion = 45;

// The candidates that the settings allow.
std::vector<Candidate> candidates(const BackendSettings& settings, std::vector<std::string>& failures) {
    std::vector<Candidate> all;
    if (settings.backend != Backend::Osmesa) {
        std::string why;
        all = eglCandidates(why);
        if (!why.empty()) failures.push_back("egl: " + why);
    }
    if (settings.backend != Backend::Egl && !settings.device) all.push_back(osmesaCandidate());
    if (!settings.device || !failures.empty()) return all;
    const auto count = std::erase_if(all, [&](const Candidate& c) { return c.device != settings.device; });
    if (all.empty()) {
        throw Error{Error::Kind::Usage,
                    fmt::format("--device: expected an EGL device that `inkedge doctor` lists, found {} among {}",
                                *settings.device, count == 0 ? 0 : count - 1)};
    }
    return all;
}

// Mesa's llvmpipe starts a thread for each core, and waits for ever for those that it does not get.
void expectThreads() {
    constexpr std::size_t maxThreads = 32;
    const std::size_t wanted = std::min<std::size_t>(std::thread::hardware_concurrency(), maxThreads);
    const std::size_t found = base::startableThreads(wanted);
    if (found == wanted) return;
    throw Error{Error::Kind::Context, fmt::format("expected {} threads for the graphics driver, found that {} can be "
                                                  "started; raise the limit (ulimit -u) or end other processes",
                                                  wanted, found)};
}

}  // namespace

void Context::load(GLADapiproc (*loader)(const char* name)) {
    const int version = gladLoadGLContext(&api_, loader);
    const auto found = GLAD_VERSION_MAJOR(version) * 10 + GLAD_VERSION_MINOR(version);
    if (found < requiredVersion) {
        throw Error{Error::Kind::Context,
                    fmt::format("expected OpenGL 4.5 core, found {}.{}; update the graphics driver or Mesa", found / 10,
                                found % 10)};
    }
    const auto text = [&](GLenum name) { return std::string{reinterpret_cast<const char*>(api_.GetString(name))}; };
    info_.vendor = text(GL_VENDOR);
    info_.renderer = text(GL_RENDERER);
    info_.version = text(GL_VERSION);
    info_.software = info_.renderer.find("llvmpipe") != std::string::npos ||
                     info_.renderer.find("softpipe") != std::string::npos ||
                     info_.renderer.find("swrast") != std::string::npos;
}

std::unique_ptr<Context> createContext(const BackendSettings& settings) {
    if (settings.backend == Backend::Osmesa && settings.device) {
        throw Error{Error::Kind::Usage, "--device: expected it with the egl backend only, found it with osmesa"};
    }
    expectThreads();
    std::vector<std::string> failures;
    for (const Candidate& candidate : candidates(settings, failures)) {
        try {
            return candidate.create(candidate);
        } catch (const Error& error) {
            failures.push_back(
                fmt::format("{} ({}): {}", candidate.info.backend, candidate.info.platform, error.what()));
        }
    }
    std::string message = "expected a context for offscreen OpenGL 4.5, found none";
    for (const std::string& failure : failures) message += "; " + failure;
    throw Error{Error::Kind::Context, message};
}

}  // namespace gl

namespace {

// All candidates; why is set to the reason if EGL has none.
std::vector<gl::Candidate> allCandidates(std::string& why) {
    std::vector<gl::Candidate> all = gl::eglCandidates(why);
    if (!why.empty()) all.push_back({{.backend = "egl", .platform = "any"}, {}, nullptr});
    all.push_back(gl::osmesaCandidate());
    return all;
}

}  // namespace

std::vector<BackendInfo> listBackends() {
    std::string why;
    std::vector<BackendInfo> list;
    for (const gl::Candidate& candidate : allCandidates(why)) list.push_back(candidate.info);
    return list;
}

BackendReport probeBackend(std::size_t number) {
    std::string why;
    const std::vector<gl::Candidate> all = allCandidates(why);
    if (number >= all.size()) {
        throw Error{Error::Kind::Usage,
                    fmt::format("backend: expected a number from 0 to {}, found {}", all.size() - 1, number)};
    }
    const gl::Candidate& candidate = all[number];
    if (candidate.create == nullptr) return {candidate.info, why};
    try {
        gl::expectThreads();
        return {candidate.create(candidate)->info(), {}};
    } catch (const Error& error) {
        return {candidate.info, error.what()};
    }
}

std::vector<BackendReport> probeBackends() {
    std::vector<BackendReport> reports;
    const std::size_t count = listBackends().size();
    for (std::size_t i = 0; i < count; ++i) reports.push_back(probeBackend(i));
    return reports;
}

}  // namespace inkedge
