#include "tune/tune.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <random>
#include <stop_token>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/error.h>

#include "io/metadata.h"
#include "tune/http.h"
#include "tune/latest_wins.h"
#include "tune/page.h"
#include "tune/request.h"
#include "tune/studio.h"
#include "tune/texts.h"

namespace inkedge::tune {
namespace {

using io::Json;

// 128 bits of chance, as hexadecimal digits.
std::string newToken() {
    std::random_device chance;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", chance(), chance(), chance(), chance());
}

// Compares all of both texts: how long that takes says nothing of where they differ.
bool isSame(std::string_view a, std::string_view b) noexcept {
    unsigned difference = a.size() == b.size() ? 0U : 1U;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
    return difference == 0;
}

Json jsonOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// What the page turns, moves and zooms from.
Json cameraJson(const StudioPicture& picture) {
    const glm::dmat4 axes = glm::inverse(picture.camera.view);
    const glm::dvec3 back{axes[2]};
    const glm::dvec3 up = picture.scene.up();
    const glm::dvec3 front = picture.scene.front();
    const double elevation = std::asin(std::clamp(glm::dot(back, up), -1.0, 1.0));
    const double azimuth = std::atan2(glm::dot(back, glm::cross(up, front)), glm::dot(back, front));
    return {{"right", jsonOf(glm::dvec3{axes[0]})},
            {"up", jsonOf(glm::dvec3{axes[1]})},
            {"back", jsonOf(back)},
            {"eye", jsonOf(glm::dvec3{axes[3]})},
            {"modelUp", jsonOf(up)},
            {"modelFront", jsonOf(front)},
            {"centre", jsonOf(picture.scene.bounds().centre)},
            {"azimuth", glm::degrees(azimuth)},
            {"elevation", glm::degrees(elevation)},
            {"orthographic", picture.camera.orthographic()},
            {"focal", picture.camera.focalLength(picture.size)}};
}

// The picture and its layers follow each other in the body; this says how long each is.
HttpAnswer answerOf(const StudioPicture& picture) {
    Json layers = Json::array();
    std::string body{picture.png.begin(), picture.png.end()};
    for (const auto& [map, png] : picture.layers) {
        layers.push_back({{"map", name(map)}, {"bytes", png.size()}});
        body.append(png.begin(), png.end());
    }
    const Json about{{"bytes", picture.png.size()},
                     {"layers", std::move(layers)},
                     {"size", {picture.size.width, picture.size.height}},
                     {"camera", cameraJson(picture)},
                     {"warnings", picture.warnings}};
    return {.type = "application/octet-stream",
            .body = std::move(body),
            .headers = {{"X-Inkedge-Picture", about.dump(-1, ' ', true, Json::error_handler_t::replace)}}};
}

HttpAnswer refusal(int status, std::string_view message) {
    return {.status = status, .body = Json{{"error", io::validText(message)}}.dump()};
}

HttpAnswer page() {
    return {.type = "text/html; charset=utf-8",
            .body = std::string{pageText},
            .headers = {{"Content-Security-Policy",
                         "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src blob: "
                         "data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"}}};
}

class Server {
public:
    explicit Server(const TuneOptions& options)
        : options_{options},
          studio_{options.model},
          beginning_{beginningJson(studio_.scene(options.settings), options.model.string(), options.settings)} {}

    [[noreturn]] void serve() {
        const std::string failure = modules::functionsOf<httpModule>(Error::Kind::Runtime)
                                        .serve(
                                            options_.port, [&](const HttpRequest& request) { return answer(request); },
                                            [&](int port) { open(port); });
        throw Error{Error::Kind::Runtime,
                    fmt::format("--port: expected one that is free, found: {}; leave it out", failure)};
    }

private:
    void open(int port) {
        hosts_ = {fmt::format("127.0.0.1:{}", port), fmt::format("localhost:{}", port)};
        if (options_.waiting) options_.waiting(fmt::format("http://{}/?token={}", hosts_[0], token_));
    }

    // Only our own page, opened by its address: no other site, by whatever name it calls this machine.
    [[nodiscard]] bool isAllowed(const HttpRequest& request) const {
        const bool host = std::ranges::find(hosts_, request.host) != hosts_.end();
        const bool origin = request.origin.empty() || request.origin == "http://" + request.host;
        return host && origin && isSame(request.token, token_);
    }

    HttpAnswer answer(const HttpRequest& request) {
        HttpAnswer given = isAllowed(request)
                               ? answerAllowed(request)
                               : refusal(403, "expected the address that inkedge tune prints, found another");
        given.headers.insert(
            given.headers.end(),
            {{"Cache-Control", "no-store"}, {"Referrer-Policy", "no-referrer"}, {"X-Content-Type-Options", "nosniff"}});
        return given;
    }

    HttpAnswer answerAllowed(const HttpRequest& request) {
        try {
            if (request.method == "GET" && request.path == "/") return page();
            if (request.method == "GET" && request.path == "/beginning") return {.body = beginning_};
            if (request.method == "POST" && request.path == "/picture") return picture(requestOf(request.body));
            if (request.method == "POST" && request.path == "/hover") return hover(requestOf(request.body));
            if (request.method == "POST" && request.path == "/texts")
                return {.body = takeAwayJson(options_.model.string(), requestOf(request.body).settings)};
            if (request.method == "POST" && request.path == "/file") return file(requestOf(request.body));
            return refusal(404, "expected what the page asks for, found another path");
        } catch (const Error& error) {
            if (error.kind() == Error::Kind::Stopped) return {.status = 204};
            return refusal(400, error.what());
        } catch (const std::bad_alloc&) {
            return refusal(500, "expected enough memory, found too little; ask for a smaller --size");
        } catch (const std::exception& error) {
            return refusal(500, error.what());
        }
    }

    HttpAnswer picture(const Request& asked) {
        const std::stop_token stop = latest_.begin(asked.tab, asked.work, asked.number);
        return answerOf(studio_.draw(asked.settings, asked.detail, stop));
    }

    HttpAnswer hover(const Request& asked) {
        const std::stop_token stop = latest_.begin(asked.tab, Work::Hover, asked.number);
        const Hovered found = studio_.hover(asked.settings, asked.x, asked.y, stop);
        return {.body = io::textOf(Json{{"types", found.types}, {"object", found.object}, {"patch", found.patch}}, -1)};
    }

    HttpAnswer file(const Request& asked) {
        const std::vector<std::uint8_t> bytes = studio_.file(asked.settings, asked.output, {});
        return {.type = "application/octet-stream", .body = std::string{bytes.begin(), bytes.end()}};
    }

    TuneOptions options_;
    Studio studio_;
    std::string beginning_;
    std::string token_ = newToken();
    std::array<std::string, 2> hosts_;
    LatestWins latest_;
};

}  // namespace

void serve(const TuneOptions& options) { Server{options}.serve(); }

}  // namespace inkedge::tune
