#pragma once

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include <inkedge/error.h>

// A module reports a failure as text of one line in the result's member `failure`, which is empty if there is none.

namespace inkedge::modules {

inline constexpr std::string_view outOfMemory = "out of memory";

/// The message of a library as one line.
[[nodiscard]] inline std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text.empty() ? "no reason given" : text;
}

/// In the module: calls a function whose result has a `failure`. An exception becomes a failure.
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

/// In the library: returns the result of a module, or throws its failure.
/// @throws std::bad_alloc  if memory was lacking
/// @throws Error           (kind) with the failure, if there is another
template <class Result>
[[nodiscard]] Result expectNoFailure(Result result, Error::Kind kind) {
    if (result.failure == outOfMemory) throw std::bad_alloc{};
    if (!result.failure.empty()) throw Error{kind, result.failure};
    return result;
}

}  // namespace inkedge::modules
