#include "io/json_object.h"

#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::io {
namespace {

std::string inWords(const ParsedJson* value) {
    if (value == nullptr) return "none";
    if (value->is_array()) return fmt::format("a list of {}", value->size());
    if (value->is_object()) return "an object";
    return base::quote(value->is_string() ? value->get_ref<const std::string&>() : value->dump());
}

}  // namespace

void refuseValue(std::string_view where, std::string_view expected, const ParsedJson* value) {
    base::refuse(fmt::format("{}: expected {}, found {}", where, expected, inWords(value)));
}

JsonObject::JsonObject(const ParsedJson* value, std::string where) : object_{value}, where_{std::move(where)} {
    if (value == nullptr || !value->is_object()) refuseValue(where_.empty() ? "lines" : where_, "an object", value);
}

std::string JsonObject::path(std::string_view key) const {
    return where_.empty() ? std::string{key} : fmt::format("{}.{}", where_, key);
}

const ParsedJson* JsonObject::at(std::string_view key) const {
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

const ParsedJson& JsonObject::list(std::string_view key) const {
    const ParsedJson* const value = at(key);
    if (value == nullptr || !value->is_array()) refuseValue(path(key), "a list", value);
    return *value;
}

std::uint64_t JsonObject::whole(std::string_view key, std::uint64_t max) const {
    const ParsedJson* const value = at(key);
    if (value == nullptr || !value->is_number_unsigned() || value->get<std::uint64_t>() > max)
        refuseValue(path(key), fmt::format("a whole number from 0 to {}", max), value);
    return value->get<std::uint64_t>();
}

std::uint32_t JsonObject::whole32(std::string_view key) const {
    return static_cast<std::uint32_t>(whole(key, std::numeric_limits<std::uint32_t>::max()));
}

double JsonObject::number(std::string_view key) const {
    const ParsedJson* const value = at(key);
    if (value == nullptr || !value->is_number()) refuseValue(path(key), "a number", value);
    return value->get<double>();
}

double JsonObject::notNegative(std::string_view key) const {
    const double value = number(key);
    if (!(value >= 0.0)) refuseValue(path(key), "a number of at least 0", at(key));
    return value;
}

bool JsonObject::flag(std::string_view key) const {
    const ParsedJson* const value = at(key);
    if (value == nullptr || !value->is_boolean()) refuseValue(path(key), "true or false", value);
    return value->get<bool>();
}

std::string JsonObject::text(std::string_view key) const {
    const ParsedJson* const value = at(key);
    if (value == nullptr || !value->is_string()) refuseValue(path(key), "a text", value);
    return value->get<std::string>();
}

}  // namespace inkedge::io
