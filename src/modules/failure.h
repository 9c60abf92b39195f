#pragma once

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include <inkedge/error.h>

// How failures come out of a module: as text of one line in the result's member `failure`, empty where there is none.

namespace inkedge {

inline constexpr std::string_view outOfMemory = "out of memory";

/// A library's message on one line.
[[nodiscard]] inline std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text.empty() ? "no reason given" : text;
}

/// In the module: calls a function whose result has a `failure`; what it throws becomes one.
template <class Function>
auto guarded(Function function) noexcept -> decltype(function()) {
    decltype(function()) result{};
    try {
        return function();
    } catch (const std::bad_alloc&) {
        result.failure = outOfMemory;
    } catch (const std::exception& exception) {
        result.failure = oneLine(exception.what());
    }
    return result;
}

/// In the library: a module's result, of which no more than its failure need be looked at before.
/// @throws std::bad_alloc  if memory was lacking
/// @throws Error           (kind) with the failure, if there is another
template <class Result>
[[nodiscard]] Result expectNoFailure(Result result, Error::Kind kind) {
    if (result.failure == outOfMemory) throw std::bad_alloc{};
    if (!result.failure.empty()) throw Error{kind, result.failure};
    return result;
}

}  // namespace inkedge
