#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/message.h"

// Structures as bytes, for a program of the same build. A structure lists its members by members(archive, it).
namespace inkedge::cad {

/// Whether a list of these is their bytes: numbers, and vectors and matrices of numbers.
template <class T>
inline constexpr bool isPlain = std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>;

/// Appends values to bytes.
class Packer {
public:
    explicit Packer(std::vector<std::uint8_t>& to) : to_{to} {}

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

private:
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_same_v<T, bool>)
            to_.push_back(value ? 1 : 0);
        else if constexpr (isPlain<T>)
            append(&value, sizeof value);
        else
            members(*this, const_cast<T&>(value));  // it is not changed
    }
    void put(const std::string& text) {
        put(std::uint64_t{text.size()});
        append(text.data(), text.size());
    }
    template <class T>
    void put(const std::vector<T>& list) {
        put(std::uint64_t{list.size()});
        if constexpr (isPlain<T>)
            append(list.data(), list.size() * sizeof(T));
        else
            for (const T& each : list) put(each);
    }
    void append(const void* data, std::size_t size) {
        if (size == 0) return;
        to_.resize(to_.size() + size);
        std::memcpy(to_.data() + to_.size() - size, data, size);
    }

    std::vector<std::uint8_t>& to_;
};

/// Takes values off bytes.
/// @throws Error  (Kind::Input) if they end too early
class Unpacker {
public:
    explicit Unpacker(std::span<const std::uint8_t> from) : from_{from} {}

    template <class... Values>
    void operator()(Values&... values) {
        (take(values), ...);
    }

private:
    template <class T>
    void take(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            copy(&byte, 1);
            value = byte != 0;
        } else if constexpr (isPlain<T>) {
            copy(&value, sizeof value);
        } else {
            members(*this, value);
        }
    }
    void take(std::string& text) {
        text.resize(takeSize(1));
        copy(text.data(), text.size());
    }
    template <class T>
    void take(std::vector<T>& list) {
        list.resize(takeSize(isPlain<T> ? sizeof(T) : 1));
        if constexpr (isPlain<T>)
            copy(list.data(), list.size() * sizeof(T));
        else
            for (T& each : list) take(each);
    }
    [[nodiscard]] std::size_t takeSize(std::size_t each) {
        std::uint64_t size = 0;
        take(size);
        if (size > from_.size() / each) refuseRest();
        return size;
    }
    void copy(void* to, std::size_t size) {
        if (size > from_.size()) refuseRest();
        if (size > 0) std::memcpy(to, from_.data(), size);
        from_ = from_.subspan(size);
    }
    [[noreturn]] static void refuseRest() {
        base::refuse("expected a whole answer of the program that reads CAD files, found a part of one");
    }

    std::span<const std::uint8_t> from_;
};

template <class T>
[[nodiscard]] std::vector<std::uint8_t> packed(const T& value) {
    std::vector<std::uint8_t> bytes;
    Packer{bytes}(value);
    return bytes;
}

template <class T>
[[nodiscard]] T unpacked(std::span<const std::uint8_t> bytes) {
    T value;
    Unpacker{bytes}(value);
    return value;
}

}  // namespace inkedge::cad
