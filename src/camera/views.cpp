#include <inkedge/views.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "base/message.h"

namespace inkedge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int maxViews = 1'000'000;
constexpr int maxDepth = 4;  // lists and objects in each other: a list of objects with lists is 3
constexpr std::uintmax_t maxFileSize = std::uintmax_t{1} << 28U;  // bytes

[[noreturn]] void refuse(Error::Kind kind, const std::string& message) { throw Error{kind, message}; }

// Numbers of equal length, so that files sort by them.
std::string numbered(int i, std::size_t count) {
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(count - 1).size());
    return fmt::format("{:0{}}", i, digits);
}

int countOf(const std::string& text, std::string_view digits) {
    int count = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error != std::errc{} || end != digits.data() + digits.size() || count < 1 || count > maxViews)
        refuse(Error::Kind::Usage,
               fmt::format("views: expected a number of views from 1 to {}, found '{}'", maxViews, text));
    return count;
}

void expectFreeDirection(const std::string& text, const CameraSettings& base) {
    if (base.position || base.direction || base.index)
        refuse(
            Error::Kind::Usage,
            fmt::format("views: expected no camera-position, camera-direction or camera-index beside '{}', found one",
                        text));
}

std::vector<View> turntable(int count, const CameraSettings& base) {
    std::vector<View> views;
    for (int i = 0; i < count; ++i) {
        views.push_back({numbered(i, static_cast<std::size_t>(count)), base});
        views.back().camera.azimuthAngle = base.azimuthAngle.value_or(0.0) + 360.0 * i / count;
    }
    return views;
}

std::vector<View> sphere(int count, const CameraSettings& base) {
    constexpr double goldenAngle = 360.0 * (2.0 - std::numbers::phi);  // degrees
    std::vector<View> views;
    for (int i = 0; i < count; ++i) {
        views.push_back({numbered(i, static_cast<std::size_t>(count)), base});
        CameraSettings& camera = views.back().camera;
        camera.azimuthAngle = std::fmod(goldenAngle * i, 360.0);
        camera.elevationAngle = glm::degrees(std::asin(1.0 - (2.0 * i + 1.0) / count));
    }
    return views;
}

// ---- a file

Json parse(const fs::path& file) {
    std::error_code failure;
    const std::uintmax_t size = fs::file_size(file, failure);
    std::ifstream stream{file, std::ios::binary};
    if (failure || !stream)
        refuse(Error::Kind::Input,
               fmt::format("{}: expected turntable:N, sphere:N or a file of views, found none that can "
                           "be read",
                           file.string()));
    if (size > maxFileSize)
        refuse(Error::Kind::Input,
               fmt::format("{}: expected at most {} bytes, found {}", file.string(), maxFileSize, size));
    try {
        return Json::parse(stream, [&](int depth, Json::parse_event_t, const Json&) {
            if (depth > maxDepth)
                refuse(Error::Kind::Usage, fmt::format("{}: expected a JSON list of views, found lists or objects over "
                                                       "{} deep",
                                                       file.string(), maxDepth));
            return true;
        });
    } catch (const Json::exception&) {
        refuse(Error::Kind::Usage,
               fmt::format("{}: expected a JSON list of views, found something else", file.string()));
    }
}

std::string textOf(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_array()) return value.dump();
    std::string text;
    for (const Json& item : value) text += (text.empty() ? "" : ",") + item.dump();
    return text;
}

bool isName(const std::string& name) {
    return !name.empty() && name.size() <= 200 && name.front() != '.' &&
           name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.") ==
               std::string::npos;
}

View viewFrom(const Json& source, std::string name, const CameraSettings& base, const std::string& where) {
    if (!source.is_object())
        refuse(Error::Kind::Usage, fmt::format("{}: expected an object, found {}", where, source.type_name()));
    Settings settings;
    settings.camera = base;
    for (const auto& [key, value] : source.items()) {
        if (key == "name") {
            name = value.is_string() ? value.get<std::string>() : std::string{};
            if (!isName(name))
                refuse(Error::Kind::Usage, fmt::format("{}: name: expected letters, digits, -, _ and ., found {}",
                                                       where, value.dump().substr(0, 80)));
            continue;
        }
        const auto& table = settingTable();
        const auto row = std::ranges::find(table, key, &SettingDescription::name);
        if (row == table.end() || row->group != "camera")
            refuse(Error::Kind::Usage,
                   fmt::format("{}: expected name or a camera setting, found {}", where, base::quote(key)));
        set(settings, key, textOf(value), where + ": " + key);
    }
    return {std::move(name), settings.camera};
}

std::vector<View> readViews(const fs::path& file, const CameraSettings& base) {
    const Json list = parse(file);
    if (!list.is_array() || list.empty() || list.size() > maxViews)
        refuse(Error::Kind::Usage,
               fmt::format("{}: expected a JSON list of 1 to {} views, found {}", file.string(), maxViews,
                           list.is_array() ? std::to_string(list.size()) : list.type_name()));
    std::vector<View> views;
    std::set<std::string> names;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = fmt::format("{}: view {}", file.string(), i);
        views.push_back(viewFrom(list[i], numbered(static_cast<int>(i), list.size()), base, where));
        if (!names.insert(views.back().name).second)
            refuse(Error::Kind::Usage,
                   fmt::format("{}: expected a name of its own, found '{}' again", where, views.back().name));
    }
    return views;
}

}  // namespace

std::vector<View> viewsOf(const std::string& text, const CameraSettings& base) {
    constexpr std::string_view turntablePrefix = "turntable:";
    constexpr std::string_view spherePrefix = "sphere:";
    const auto countAfter = [&](std::string_view prefix) {
        expectFreeDirection(text, base);
        return countOf(text, std::string_view{text}.substr(prefix.size()));
    };
    if (text.starts_with(turntablePrefix)) return turntable(countAfter(turntablePrefix), base);
    if (text.starts_with(spherePrefix)) return sphere(countAfter(spherePrefix), base);
    return readViews(text, base);
}

}  // namespace inkedge
