#include "batch/item.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "batch/results.h"
#include "io/json_object.h"
#include "io/parse_json.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::array ownFiles{"batch.json"sv, "gallery.html"sv};  // of the batch, beside its results
constexpr std::size_t maxId = 1000;                               // bytes
constexpr std::size_t maxName = 255;                              // bytes, as file systems have it
constexpr io::JsonLimits lineLimits{.depth = 8, .values = 100'000};

std::string_view faultOfName(std::string_view name) {
    if (name.empty()) return "a name without letters";
    if (name.front() == '.') return "one that begins with a dot";
    if (name.size() > maxName) return "one of over 255 bytes";
    const auto refused = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\'; };
    if (std::ranges::any_of(name, refused)) return "a backslash or a control character";
    return {};
}

std::string_view faultOf(std::string_view id) {
    if (id.size() > maxId) return "over 1000 bytes";
    if (io::validText(id) != id) return "bytes that are no UTF-8";
    const std::string_view first = id.substr(0, id.find('/'));
    if (isResultsFile(first) || std::ranges::find(ownFiles, first) != ownFiles.end())
        return "a name of the batch's own";
    for (std::string_view rest = id;;) {
        const std::size_t slash = rest.find('/');
        if (const std::string_view fault = faultOfName(rest.substr(0, slash)); !fault.empty()) return fault;
        if (slash == std::string_view::npos) return {};
        rest.remove_prefix(slash + 1);
    }
}

void expectId(std::string_view id) {
    if (const std::string_view fault = faultOf(id); !fault.empty())
        base::refuse(
            fmt::format("id: expected names with / between them, none of which begins with a dot, found {} in {}",
                        fault, base::quote(id)));
}

// The path without what leads out of where the reader stands.
std::string idFrom(const fs::path& model) {
    fs::path id;
    for (const fs::path& part : model.lexically_normal().relative_path())
        if (part != ".." && part != ".") id /= part;
    return id.string();
}

Item named(Item item) {
    if (item.model.empty()) base::refuse("model: expected a path, found an empty text");
    if (item.id.empty()) item.id = idFrom(item.model);
    expectId(item.id);
    return item;
}

Item parsed(std::string_view line) {
    const io::ParsedJson json = io::parseJson(line, {{}, {}}, lineLimits);
    const io::JsonObject object{&json, ""};
    Item item;
    item.model = object.text("model");
    for (const auto& [key, value] : json.items()) {
        if (key == "id")
            item.id = object.text(key);
        else if (key == "views")
            item.views = object.text(key);
        else if (key == "settings" && value.is_object())
            item.settings = value;
        else if (key == "settings")
            io::refuseValue(key, "an object", &value);
        else if (key != "model")
            base::refuse(fmt::format("expected model, id, views and settings, found {}", base::quote(key)));
    }
    if (json.contains("id") && item.id.empty()) base::refuse("id: expected a name, found an empty text");
    return item;
}

}  // namespace

Item itemFrom(std::string_view line) { return named(line.starts_with('{') ? parsed(line) : Item{.model = line}); }

Item itemOf(const fs::path& model, const fs::path& relative) {
    return named({.id = relative.string(), .model = model});
}

std::string lineOf(const Item& item) {
    io::Json json{{"model", item.model.string()}, {"id", item.id}};
    if (!item.views.empty()) json["views"] = item.views;
    if (item.settings.is_object()) json["settings"] = item.settings;
    return io::textOf(json, -1);
}

}  // namespace inkedge::batch
