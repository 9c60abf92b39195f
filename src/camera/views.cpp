#include <inkedge/views.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include <inkedge/setting_table.h>

#include "base/message.h"
#include "settings/json_text.h"
#include "settings/names.h"
#include "settings/text.h"

namespace inkedge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int maxViews = 1'000'000;
constexpr int maxDepth = 4;  // lists and objects in each other: a list of objects with lists is 3
constexpr std::uintmax_t maxFileSize = std::uintmax_t{1} << 28U;  // bytes

// Numbers of equal length, so that files sort by them.
std::string numbered(std::size_t i, std::size_t count) {
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(count - 1).size());
    return fmt::format("{:0{}}", i, digits);
}

int countOf(const std::string& text, std::string_view digits) {
    int count = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error != std::errc{} || end != digits.data() + digits.size() || count < 1 || count > maxViews)
        base::refuseUse(fmt::format("--views: expected a number of views from 1 to {}, found '{}'", maxViews, text));
    return count;
}

void turntable(int count, const CameraSettings& base, std::vector<CameraSettings>& cameras) {
    for (int i = 0; i < count; ++i) {
        cameras.push_back(base);
        cameras.back().azimuthAngle = base.azimuthAngle.value_or(0.0) + 360.0 * i / count;
    }
}

void sphere(int count, const CameraSettings& base, std::vector<CameraSettings>& cameras) {
    constexpr double goldenAngle = 360.0 * (2.0 - std::numbers::phi);  // degrees
    for (int i = 0; i < count; ++i) {
        CameraSettings& camera = cameras.emplace_back(base);
        camera.azimuthAngle = std::fmod(goldenAngle * i, 360.0);
        camera.elevationAngle = glm::degrees(std::asin(1.0 - (2.0 * i + 1.0) / count));
    }
}

// ---- a list

std::uint64_t seedOf(const std::string& text, std::string_view digits) {
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
    if (error != std::errc{} || end != digits.data() + digits.size())
        base::refuseUse(fmt::format("--views: expected a whole number as the seed of random views, found '{}'", text));
    return seed;
}

// Evenly likely directions. The engine's numbers are the same everywhere, those of the standard's distributions not.
void random(const std::string& text, std::string_view numbers, const CameraSettings& base,
            std::vector<CameraSettings>& cameras) {
    const std::size_t colon = numbers.find(':');
    std::mt19937_64 engine{colon == std::string_view::npos ? 0 : seedOf(text, numbers.substr(colon + 1))};
    const auto share = [&] { return std::ldexp(static_cast<double>(engine() >> 11U), -53); };  // 0 to under 1
    const int count = countOf(text, numbers.substr(0, colon));
    for (int i = 0; i < count; ++i) {
        CameraSettings& camera = cameras.emplace_back(base);
        camera.azimuthAngle = 360.0 * share();
        camera.elevationAngle = glm::degrees(std::asin(2.0 * share() - 1.0));
    }
}

using AddCameras = void (*)(const std::string& text, std::string_view numbers, const CameraSettings& base,
                            std::vector<CameraSettings>&);
constexpr std::array<std::pair<std::string_view, AddCameras>, 3> numberedItems{{
    {"turntable:", [](const std::string& text, std::string_view numbers, const CameraSettings& base,
                      auto& cameras) { turntable(countOf(text, numbers), base, cameras); }},
    {"sphere:", [](const std::string& text, std::string_view numbers, const CameraSettings& base,
                   auto& cameras) { sphere(countOf(text, numbers), base, cameras); }},
    {"random:", random},
}};

std::optional<NamedView> namedView(std::string_view text) {
    const auto* const found = std::ranges::find(settings::namedViewNames, text);
    if (found == settings::namedViewNames.end()) return {};
    return static_cast<NamedView>(found - settings::namedViewNames.begin());
}

bool isItem(std::string_view text) {
    return namedView(text) ||
           std::ranges::any_of(numberedItems, [&](const auto& item) { return text.starts_with(item.first); });
}

std::string itemForms() {
    return fmt::format("{}, turntable:N, sphere:N or random:N:SEED", fmt::join(settings::namedViewNames, ", "));
}

void expectFreeDirection(const std::string& text, const CameraSettings& base, bool allNamed) {
    const bool free = !base.position && !base.direction && !base.index && !base.view;
    if (!free)
        base::refuseUse(
            fmt::format("--views: expected no --camera-position, --camera-direction, --camera-index or --view beside "
                        "'{}', found one",
                        text));
    if (allNamed && (base.azimuthAngle || base.elevationAngle))
        base::refuseUse(fmt::format("--views: expected no azimuth or elevation angle beside '{}', found one", text));
}

// Named views and those that are numbered, in their order.
std::vector<View> listedViews(const std::string& text, CameraSettings base) {
    const std::vector<std::string_view> items = settings::split(text, ',');
    const auto isNamed = [](std::string_view item) { return namedView(item).has_value(); };
    const bool named = std::ranges::any_of(items, isNamed);
    expectFreeDirection(text, base, std::ranges::all_of(items, isNamed));
    if (named && !base.viewAngle && !base.orthographicHeight) base.orthographicHeight = 0.0;
    std::vector<View> views;
    std::vector<CameraSettings> numberedCameras;
    std::vector<std::size_t> numberedViews;  // where in the list they stand
    std::set<std::string_view> names;
    for (const std::string_view item : items) {
        if (views.size() >= maxViews)
            base::refuseUse(fmt::format("--views: expected at most {} views, found more", maxViews));
        if (const std::optional<NamedView> view = namedView(item)) {
            if (!names.insert(item).second)
                base::refuseUse(fmt::format("--views: expected each view once, found '{}' again", item));
            views.push_back({std::string{item}, base});
            views.back().camera.view = view;
            views.back().camera.azimuthAngle.reset();
            views.back().camera.elevationAngle.reset();
            continue;
        }
        const std::size_t before = numberedCameras.size();
        for (const auto& [prefix, add] : numberedItems)
            if (item.starts_with(prefix)) add(text, item.substr(prefix.size()), base, numberedCameras);
        for (std::size_t i = before; i < numberedCameras.size(); ++i) {
            numberedViews.push_back(views.size());
            views.push_back({{}, numberedCameras[i]});
        }
    }
    for (std::size_t i = 0; i < numberedViews.size(); ++i)
        views[numberedViews[i]].name = numbered(i, numberedViews.size());
    return views;
}

// ---- a file

Json parse(const fs::path& file) {
    std::error_code failure;
    const std::uintmax_t size = fs::file_size(file, failure);
    std::ifstream stream{file, std::ios::binary};
    if (failure || !stream)
        base::refuse(fmt::format("{}: expected {}, or a file of views, found none that can be read", file.string(),
                                 itemForms()));
    if (size > maxFileSize)
        base::refuse(fmt::format("{}: expected at most {} bytes, found {}", file.string(), maxFileSize, size));
    try {
        return Json::parse(stream, [&](int depth, Json::parse_event_t, const Json&) {
            if (depth > maxDepth)
                base::refuseUse(
                    fmt::format("{}: expected a JSON list of views, found lists or objects over "
                                "{} deep",
                                file.string(), maxDepth));
            return true;
        });
    } catch (const Json::exception&) {
        base::refuseUse(fmt::format("{}: expected a JSON list of views, found something else", file.string()));
    }
}

bool isName(const std::string& name) {
    return !name.empty() && name.size() <= 200 && name.front() != '.' &&
           name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.") ==
               std::string::npos;
}

View viewFrom(const Json& source, std::string name, const CameraSettings& base, const std::string& where) {
    if (!source.is_object())
        base::refuseUse(fmt::format("{}: expected an object, found {}", where, source.type_name()));
    Settings settings;
    settings.camera = base;
    for (const auto& [key, value] : source.items()) {
        if (key == "name") {
            name = value.is_string() ? value.get<std::string>() : std::string{};
            if (!isName(name))
                base::refuseUse(fmt::format("{}: name: expected letters, digits, -, _ and ., found {}", where,
                                            value.dump().substr(0, 80)));
            continue;
        }
        const SettingDescription* const row = findSetting(key);
        if (row == nullptr || row->group != "camera")
            base::refuseUse(
                fmt::format("{}: expected name or a camera setting, as azimuth or "
                            "camera-position, found {}",
                            where, base::quote(key)));
        set(settings, key, settings::textOfJson(value), where + ": " + key);
    }
    return {std::move(name), settings.camera};
}

std::vector<View> readViews(const fs::path& file, const CameraSettings& base) {
    const Json list = parse(file);
    if (!list.is_array() || list.empty() || list.size() > maxViews)
        base::refuseUse(fmt::format("{}: expected a JSON list of 1 to {} views, found {}", file.string(), maxViews,
                                    list.is_array() ? std::to_string(list.size()) : list.type_name()));
    std::vector<View> views;
    std::set<std::string> names;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = fmt::format("{}: view {}", file.string(), i);
        views.push_back(viewFrom(list[i], numbered(i, list.size()), base, where));
        if (!names.insert(views.back().name).second)
            base::refuseUse(fmt::format("{}: expected a name of its own, found '{}' again", where, views.back().name));
    }
    return views;
}

}  // namespace

std::vector<View> viewsOf(const std::string& text, const CameraSettings& base) {
    const std::vector<std::string_view> items = settings::split(text, ',');
    const auto wrong = std::ranges::find_if_not(items, isItem);
    if (wrong == items.end()) return listedViews(text, base);
    if (std::ranges::any_of(items, isItem))
        base::refuseUse(fmt::format("--views: expected {}, found '{}'", itemForms(), *wrong));
    return readViews(text, base);
}

LoadSettings loadSettings(const Settings& settings, std::span<const View> views) {
    LoadSettings load = loadSettings(settings);
    if (views.empty()) return load;
    load.pictures.cameras.clear();
    for (const View& view : views) load.pictures.cameras.push_back(view.camera);
    return load;
}

}  // namespace inkedge
