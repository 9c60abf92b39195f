#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include <inkedge/error.h>

/// What libFuzzer calls, over and over, with what it makes up.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace inkedge::fuzz {

/// Ends the process as a finding unless the promise was kept.
inline void expect(bool kept, std::string_view promise, std::string_view found) {
    if (kept) return;
    std::fprintf(stderr, "expected %.*s, found %.*s\n", static_cast<int>(promise.size()), promise.data(),
                 static_cast<int>(found.size()), found.data());
    std::abort();
}

inline void write(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
    std::ofstream{file, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                static_cast<std::streamsize>(bytes.size()));
}

/// Runs an action that may throw an Error of one line, and nothing else.
template <class Action>
void mayBeRefused(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        const std::string_view text = error.what();
        expect(text.find('\n') == std::string_view::npos, "an error of one line", text);
        expect(text.find("expected") != std::string_view::npos && text.find("found") != std::string_view::npos,
               "an error that says what was expected and what was found", text);
    }
}

}  // namespace inkedge::fuzz
