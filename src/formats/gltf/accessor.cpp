#include "formats/gltf/accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "base/message.h"
#include "formats/gltf/triangles.h"

namespace inkedge::gltf {

namespace {

constexpr std::uint64_t maximumElements = std::uint64_t{1} << 28;

// Where numbers lie in memory, once all of them are known to be there.
struct Source {
    const std::uint8_t* start = nullptr;
    std::uint64_t stride = 0;  // from element to element, bytes
    std::uint64_t count = 0;
    std::uint64_t components = 0;  // an element
};

template <class T>
T valueAt(const std::uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class T>
double normalized(T value) {
    if constexpr (std::is_floating_point_v<T>)
        return static_cast<double>(value);
    else
        return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

// Calls write(index, value) for every number.
template <class T, class Write>
void forEachNumber(const Source& source, Write&& write) {
    std::uint64_t index = 0;
    for (std::uint64_t i = 0; i < source.count; ++i)
        for (std::uint64_t c = 0; c < source.components; ++c)
            write(index++, valueAt<T>(source.start + i * source.stride + c * sizeof(T)));
}

// Converts integers without scaling.
template <class T>
void copyIntegers(const Source& source, std::uint32_t* numbers) {
    forEachNumber<T>(source, [&](std::uint64_t i, T value) { numbers[i] = value; });
}

template <class T>
void decode(const Source& source, double* numbers) {
    forEachNumber<T>(source, [&](std::uint64_t i, T value) { numbers[i] = static_cast<double>(value); });
}

template <class T>
void decodeNormalized(const Source& source, double* numbers) {
    forEachNumber<T>(source, [&](std::uint64_t i, T value) { numbers[i] = normalized(value); });
}

using Decode = void (*)(const Source&, double* numbers);

struct ComponentFormat {
    std::string_view name;
    std::uint64_t size;
    double largest;  // of unsigned components: the primitive restart value
    Decode decode;
    Decode decodeNormalized;
};

template <class T>
constexpr ComponentFormat formatOf(std::string_view name) {
    return {name, sizeof(T), static_cast<double>(std::numeric_limits<T>::max()), decode<T>, decodeNormalized<T>};
}

ComponentFormat formatOf(Component component) {
    switch (component) {
        case Component::Int8:
            return formatOf<std::int8_t>("BYTE");
        case Component::Uint8:
            return formatOf<std::uint8_t>("UNSIGNED_BYTE");
        case Component::Int16:
            return formatOf<std::int16_t>("SHORT");
        case Component::Uint16:
            return formatOf<std::uint16_t>("UNSIGNED_SHORT");
        case Component::Uint32:
            return formatOf<std::uint32_t>("UNSIGNED_INT");
        case Component::Float:
            return formatOf<float>("FLOAT");
    }
    base::refuse(fmt::format("expected componentType 5120, 5121, 5122, 5123, 5125 or 5126, found {}",
                             static_cast<int>(component)));
}

void checkExpected(const Accessor& accessor, const Expected& expected) {
    const std::string_view found = formatOf(accessor.component).name;
    if (accessor.type == expected.type && std::ranges::count(expected.components, accessor.component) == 1) return;
    std::string names;
    for (const Component component : expected.components) {
        if (!names.empty()) names += " or ";
        names += formatOf(component).name;
    }
    base::refuse(
        fmt::format("expected {} of {}, found {} of {}", expected.type.name, names, accessor.type.name, found));
}

// The distance between elements; checks that all of them lie within their bytes.
std::uint64_t checkedStride(const Elements& elements, std::uint64_t count, std::uint64_t elementSize) {
    const std::uint64_t stride = elements.stride == 0 ? elementSize : elements.stride;
    const std::uint64_t size = elements.bytes.size();
    if (stride < elementSize)
        base::refuse(fmt::format("expected a byteStride of at least {}, found {}", elementSize, stride));
    const bool fits = count == 0 || (elements.offset <= size && size - elements.offset >= elementSize &&
                                     (size - elements.offset - elementSize) / stride >= count - 1);
    if (!fits)
        base::refuse(fmt::format(
            "expected {} elements of {} bytes, {} bytes apart, from byte {}, found a bufferView of {} bytes", count,
            elementSize, stride, elements.offset, size));
    return stride;
}

// Where an accessor's own numbers lie. Without a start all of them are zeros.
Source sourceOf(const Accessor& accessor, const Expected& expected) {
    checkExpected(accessor, expected);
    if (accessor.count > maximumElements)
        base::refuse(fmt::format("expected at most {} elements, found {}", maximumElements, accessor.count));
    Source source{nullptr, 0, accessor.count, accessor.type.components};
    if (!accessor.elements) return source;
    const std::uint64_t elementSize = source.components * formatOf(accessor.component).size;
    source.stride = checkedStride(*accessor.elements, accessor.count, elementSize);
    if (accessor.count > 0) source.start = accessor.elements->bytes.data() + accessor.elements->offset;
    return source;
}

template <class Number>
void readSparse(const Accessor& accessor, const Accessor::Sparse& sparse, std::vector<Number>& numbers) {
    const std::uint64_t components = accessor.type.components;
    const Accessor indexSource{scalar, sparse.indexComponent, false, sparse.count, sparse.indices, {}};
    const Accessor replacements{accessor.type, accessor.component, accessor.normalized,
                                sparse.count,  sparse.values,      {}};
    const std::vector<double> at =
        readNumbers(indexSource, {scalar, {Component::Uint8, Component::Uint16, Component::Uint32}});
    const std::vector<double> values = readNumbers(replacements, {accessor.type, {accessor.component}});
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!(at[i] < static_cast<double>(accessor.count)))
            base::refuse(fmt::format("expected sparse indices below {}, found {}", accessor.count, at[i]));
        std::transform(values.begin() + static_cast<std::ptrdiff_t>(i * components),
                       values.begin() + static_cast<std::ptrdiff_t>((i + 1) * components),
                       numbers.begin() + static_cast<std::ptrdiff_t>(static_cast<std::uint64_t>(at[i]) * components),
                       [](double value) { return static_cast<Number>(value); });
    }
}

[[noreturn]] void refuseIndex(double number, std::size_t index, double restart, std::uint64_t vertexCount) {
    if (number == restart)
        base::refuse(
            fmt::format("expected vertex indices, found the primitive restart value {} at index {}", number, index));
    base::refuse(fmt::format("expected vertex indices below {}, found {} at index {}", vertexCount, number, index));
}

}  // namespace

std::span<const std::uint8_t> slice(std::span<const std::uint8_t> buffer, std::uint64_t offset, std::uint64_t length) {
    if (offset > buffer.size() || length > buffer.size() - offset)
        base::refuse(
            fmt::format("expected {} bytes from byte {}, found a buffer of {} bytes", length, offset, buffer.size()));
    return buffer.subspan(offset, length);
}

std::vector<double> readNumbers(const Accessor& accessor, const Expected& expected) {
    const Source source = sourceOf(accessor, expected);
    const ComponentFormat format = formatOf(accessor.component);
    std::vector<double> numbers(source.count * source.components);
    if (source.start != nullptr)
        (accessor.normalized ? format.decodeNormalized : format.decode)(source, numbers.data());
    if (accessor.sparse) readSparse(accessor, *accessor.sparse, numbers);
    return numbers;
}

std::vector<std::uint32_t> readIndices(const Accessor& accessor, std::uint64_t vertexCount, Restarts restarts) {
    const Source source = sourceOf(accessor, {scalar, {Component::Uint8, Component::Uint16, Component::Uint32}});
    if (accessor.normalized) base::refuse("expected indices that are not normalized, found normalized ones");
    std::vector<std::uint32_t> indices(source.count);
    if (source.start != nullptr && accessor.component == Component::Uint8)
        copyIntegers<std::uint8_t>(source, indices.data());
    else if (source.start != nullptr && accessor.component == Component::Uint16)
        copyIntegers<std::uint16_t>(source, indices.data());
    else if (source.start != nullptr)
        copyIntegers<std::uint32_t>(source, indices.data());
    if (accessor.sparse) readSparse(accessor, *accessor.sparse, indices);

    const double largest = formatOf(accessor.component).largest;
    const std::uint64_t end = std::min(vertexCount, static_cast<std::uint64_t>(largest));
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < end) continue;
        if (indices[i] != largest || restarts == Restarts::Refused) refuseIndex(indices[i], i, largest, vertexCount);
        indices[i] = restart;
    }
    return indices;
}

}  // namespace inkedge::gltf
