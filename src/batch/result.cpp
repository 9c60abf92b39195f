#include "batch/result.h"

#include <algorithm>
#include <cmath>

namespace inkedge::batch {
namespace {

using io::Json;
using namespace std::string_view_literals;

constexpr std::string_view beforeId = R"({"id":")";
constexpr std::string_view afterId = R"(,"state":")";

double rounded(double value) { return std::round(value * 1000.0) / 1000.0; }

std::optional<State> stateOf(std::string_view name) {
    const auto* const found = std::ranges::find(stateNames, name);
    if (found == stateNames.end()) return {};
    return static_cast<State>(found - stateNames.begin());
}

}  // namespace

Json lengthsJson(const LineLengths& lengths) {
    Json json = Json::object();
    for (const LineType type : allLineTypes)
        if (const double length = lengths[static_cast<std::size_t>(bitIndex(type))]; length > 0.0)
            json[std::string{name(type)}] = rounded(length);
    return json;
}

std::string lineOf(const Result& result) {
    Json json{{"id", result.id},
              {"state", stateNames[static_cast<std::size_t>(result.state)]},
              {"model", result.model},
              {"key", result.key},
              {"files", result.files},
              {"seconds", rounded(result.seconds)},
              {"triangles", result.triangles},
              {"lengths", lengthsJson(result.lengths)},
              {"warnings", result.warnings},
              {"error", result.error.empty() ? Json{} : Json(result.error)}};
    if (result.score)
        json["score"] = {{"precision", rounded(result.score->precision())},
                         {"recall", rounded(result.score->recall())},
                         {"f1", rounded(result.score->f1())}};
    if (result.limit) json["limit"] = *result.limit;
    if (!result.others.is_null()) json["others"] = result.others;
    return io::textOf(json, -1) + '\n';
}

std::optional<EarlierResult> earlierResult(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    const auto text = [&](const char* key) -> std::string {
        const auto found = json.find(key);
        return found != json.end() && found->is_string() ? found->get<std::string>() : std::string{};
    };
    if (!json.is_object()) return {};
    const std::optional<State> state = stateOf(text("state"));
    EarlierResult earlier{.id = text("id"), .state = state.value_or(State::Failed), .key = text("key")};
    if (!state || earlier.id.empty()) return {};
    earlier.error = text("error");
    if (json.contains("limit") && json["limit"].is_number()) earlier.limit = json["limit"].get<double>();
    if (json.contains("others")) earlier.others = json["others"];
    return earlier;
}

std::optional<ResultStart> startOf(std::string_view line) {
    if (!line.starts_with(beforeId) || !line.ends_with('}')) return {};
    std::size_t end = beforeId.size();
    while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
    const std::string_view after = line.substr(std::min(end + 1, line.size()));
    if (!after.starts_with(afterId)) return {};
    return ResultStart{line.substr(beforeId.size(), end - beforeId.size()),
                       after.substr(afterId.size()).starts_with("drawn\"")};
}

}  // namespace inkedge::batch
