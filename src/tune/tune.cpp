#include "tune/tune.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <random>
#include <stop_token>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "io/metadata.h"
#include "io/parse_json.h"
#include "tune/http.h"
#include "tune/page.h"
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

// The pictures that each tab of a browser asks for. The last one of a tab is drawn, and ends those before it.
class LatestWins {
public:
    /// Asks what a tab asked for before to stop.
    std::stop_token begin(const std::string& tab) {
        const std::scoped_lock lock{guard_};
        std::stop_source& source = tabs_[tab];
        source.request_stop();
        source = std::stop_source{};
        if (tabs_.size() > maxTabs) tabs_.erase(tabs_.begin()->first == tab ? std::prev(tabs_.end()) : tabs_.begin());
        return source.get_token();
    }

private:
    static constexpr std::size_t maxTabs = 256;
    std::mutex guard_;
    std::map<std::string, std::stop_source> tabs_;
};

// What a request asks for.
struct Asked {
    std::string tab;
    Settings settings;
    std::optional<Map> map = {};
    Detail detail = Detail::Full;
    std::string output = "drawing.png";
    int x = 0;
    int y = 0;
};

Asked askedBy(const std::string& body, const Settings& own) {
    const io::ParsedJson json = io::parseJson(body, {"", {}}, {.depth = 4, .values = 4096});
    std::map<std::string, std::string> texts;
    for (const auto& [name, text] : json.at("settings").items()) texts[name] = text.get<std::string>();
    Asked asked{.tab = json.value("tab", ""), .settings = settingsOf(texts)};
    asked.settings.backend = own.backend;
    asked.detail = json.value("half", false) ? Detail::Half : Detail::Full;
    asked.output = json.value("output", asked.output);
    asked.x = json.value("x", 0);
    asked.y = json.value("y", 0);
    if (const std::string map = json.value("map", ""); !map.empty()) {
        Settings withMap;
        set(withMap, "maps", map, "map");
        asked.map = withMap.maps.front();
    }
    return asked;
}

// Files that may be asked for: no name leads anywhere, for nothing is written.
void expectKnownOutput(const std::string& output) {
    constexpr std::array<std::string_view, 5> known{"drawing.png", "drawing.svg", "drawing.pdf", "drawing.dxf",
                                                    "drawing.json"};
    if (std::ranges::find(known, output) == known.end())
        throw Error{Error::Kind::Usage, "output: expected drawing.png, .svg, .pdf, .dxf or .json, found another"};
}

std::string cameraHeader(const StudioFile& file) {
    Json view = Json::array();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) view.push_back(file.camera.view[column][row]);
    const Json json{{"view", std::move(view)},
                    {"focal", file.camera.focalLength(file.size)},
                    {"orthographic", file.camera.orthographic()},
                    {"size", {file.size.width, file.size.height}}};
    return json.dump();
}

class Server {
public:
    explicit Server(const TuneOptions& options)
        : options_{options}, studio_{options.model},
          beginning_{beginningJson(studio_.scene(options.settings), options.model.string(), options.settings)} {}

    [[noreturn]] void serve() {
        const std::string failure = modules::functionsOf<httpModule>(Error::Kind::Runtime)
                                        .serve(
                                            options_.port, [&](const HttpRequest& request) { return answer(request); },
                                            [&](int port) { wait(port); });
        throw Error{Error::Kind::Runtime,
                    fmt::format("--port: expected one that is free, found: {}; leave it out", failure)};
    }

private:
    void wait(int port) {
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
        try {
            if (!isAllowed(request)) return refusal(403, "expected the address that inkedge tune prints, found another");
            if (request.method == "GET" && request.path == "/") return page();
            if (request.method == "GET" && request.path == "/beginning") return {.body = beginning_};
            if (request.method == "POST" && request.path == "/picture") return picture(request.body);
            if (request.method == "POST" && request.path == "/file") return file(request.body);
            if (request.method == "POST" && request.path == "/texts") return texts(request.body);
            if (request.method == "POST" && request.path == "/hover") return hover(request.body);
            return refusal(404, "expected what the page asks for, found another path");
        } catch (const Error& error) {
            if (error.kind() == Error::Kind::Stopped) return {.status = 204};
            return refusal(400, error.what());
        } catch (const std::bad_alloc&) {
            return refusal(500, "expected enough memory, found too little; ask for a smaller --size");
        } catch (const nlohmann::json::exception& error) {
            return refusal(400, error.what());
        } catch (const std::exception& error) {
            return refusal(500, error.what());
        }
    }

    static HttpAnswer refusal(int status, std::string_view message) {
        return {.status = status, .body = Json{{"error", io::validText(message)}}.dump()};
    }

    static HttpAnswer page() {
        return {.type = "text/html; charset=utf-8",
                .body = std::string{pageText},
                .headers = {{"Content-Security-Policy",
                             "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src blob: "
                             "data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
                            {"Referrer-Policy", "no-referrer"},
                            {"X-Content-Type-Options", "nosniff"},
                            {"Cache-Control", "no-store"}}};
    }

    HttpAnswer picture(const std::string& body) {
        const Asked asked = askedBy(body, options_.settings);
        const std::stop_token stop = latest_.begin(asked.tab);
        const StudioFile drawn = studio_.draw(asked.settings, "drawing.png", asked.map, asked.detail, stop);
        return {.type = "image/png",
                .body = std::string{drawn.bytes.begin(), drawn.bytes.end()},
                .headers = {{"X-Inkedge-Camera", cameraHeader(drawn)}, {"Cache-Control", "no-store"}}};
    }

    HttpAnswer file(const std::string& body) {
        const Asked asked = askedBy(body, options_.settings);
        expectKnownOutput(asked.output);
        const StudioFile drawn = studio_.draw(asked.settings, asked.output, {}, Detail::Full, {});
        return {.type = "application/octet-stream", .body = std::string{drawn.bytes.begin(), drawn.bytes.end()}};
    }

    HttpAnswer texts(const std::string& body) {
        return {.body = takeAwayJson(options_.model.string(), askedBy(body, options_.settings).settings)};
    }

    HttpAnswer hover(const std::string& body) {
        const Asked asked = askedBy(body, options_.settings);
        const Hovered found = studio_.hover(asked.settings, asked.x, asked.y);
        return {.body = io::textOf(Json{{"types", found.types}, {"object", found.object}, {"patch", found.patch}}, -1)};
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
