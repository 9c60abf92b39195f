#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/ranges.h>

#include "io/parse_json.h"

namespace inkedge::io {

/// @throws Error  (Kind::Input) always: what was expected at a key and what stands there
/// @param value   null: the key is not there
[[noreturn]] void refuseValue(std::string_view where, std::string_view expected, const ParsedJson* value);

/// A list of numbers, as many as a vector has components.
template <class Vector>
Vector vectorOf(const ParsedJson& value, const std::string& where) {
    constexpr auto count = static_cast<std::size_t>(Vector::length());
    const auto refused = [&] { refuseValue(where, fmt::format("a list of {} numbers", count), &value); };
    if (!value.is_array() || value.size() != count) refused();
    Vector vector{0.0};
    for (std::size_t k = 0; k < count; ++k) {
        if (!value[k].is_number()) refused();
        vector[static_cast<int>(k)] = value[k].template get<double>();
    }
    return vector;
}

/// The values of one JSON object, each of the type that is asked for: what is missing, of another type or out of range
/// is refused as refuseValue() does. Holds a reference to the JSON.
class JsonObject {
public:
    /// @param value  null is refused as what is no object is
    /// @param where  the keys that lead to it; empty: it is the whole
    JsonObject(const ParsedJson* value, std::string where);

    /// The keys that lead to one of its values.
    [[nodiscard]] std::string path(std::string_view key) const;
    /// Null if the key is not there.
    [[nodiscard]] const ParsedJson* at(std::string_view key) const;

    [[nodiscard]] JsonObject object(std::string_view key) const { return {at(key), path(key)}; }
    [[nodiscard]] const ParsedJson& list(std::string_view key) const;
    [[nodiscard]] std::uint64_t whole(std::string_view key, std::uint64_t max) const;
    [[nodiscard]] std::uint32_t whole32(std::string_view key) const;
    [[nodiscard]] double number(std::string_view key) const;
    [[nodiscard]] double notNegative(std::string_view key) const;
    [[nodiscard]] bool flag(std::string_view key) const;
    [[nodiscard]] std::string text(std::string_view key) const;
    template <class Vector>
    [[nodiscard]] Vector vector(std::string_view key) const {
        return vectorOf<Vector>(list(key), path(key));
    }
    /// The index of a text among names.
    template <std::size_t count>
    [[nodiscard]] std::size_t choice(std::string_view key, const std::array<std::string_view, count>& names) const {
        const std::string chosen = text(key);
        for (std::size_t i = 0; i < count; ++i)
            if (names[i] == chosen) return i;
        refuseValue(path(key), fmt::format("one of {}", fmt::join(names, ", ")), at(key));
    }

private:
    const ParsedJson* object_;
    std::string where_;
};

}  // namespace inkedge::io
