#include "formats/gltf/json.h"

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

std::string found(const Json& value) { return base::printable(std::string_view{value.dump()}.substr(0, 80)); }

const Json& member(const Json& object, const char* key) {
    static const Json none;
    const auto at = object.is_object() ? object.find(key) : object.end();
    return at == object.end() ? none : *at;
}

std::uint64_t number(const Json& object, const char* key, std::optional<std::uint64_t> otherwise) {
    const Json& value = member(object, key);
    if (value.is_null() && otherwise) return *otherwise;
    if (!value.is_number_unsigned())
        base::refuse(fmt::format("expected a number of at least 0 as {}, found {}", key, found(value)));
    return value.get<std::uint64_t>();
}

std::string text(const Json& object, const char* key, const char* otherwise) {
    const Json& value = member(object, key);
    if (value.is_null()) return otherwise;
    if (!value.is_string()) base::refuse(fmt::format("expected a string as {}, found {}", key, found(value)));
    return value.get<std::string>();
}

const Json& extension(const Json& object, const char* name) { return member(member(object, "extensions"), name); }

std::size_t sizeOf(const Json& list) { return list.is_array() ? list.size() : 0; }

const Json& entry(const Json& document, const char* list, std::uint64_t index) {
    const Json& all = member(document, list);
    if (index >= sizeOf(all))
        base::refuse(fmt::format("expected an index of {} below {}, found {}", list, sizeOf(all), index));
    return all[index];
}

}  // namespace inkedge::gltf
