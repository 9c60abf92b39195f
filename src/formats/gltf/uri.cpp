#include "formats/gltf/uri.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

namespace {

namespace fs = std::filesystem;

constexpr std::uint8_t notBase64 = 0xff;

constexpr std::array<std::uint8_t, 256> base64Values() {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::uint8_t, 256> values{};
    values.fill(notBase64);
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    return values;
}

std::vector<std::uint8_t> decodeBase64(std::string_view text) {
    constexpr std::array<std::uint8_t, 256> values = base64Values();
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char character : text) {
        const std::uint8_t value = values[static_cast<unsigned char>(character)];
        if (value == notBase64) base::refuse(fmt::format("expected base64, found {}", base::quote({&character, 1})));
        bits = (bits << 6 | value) & 0xffff;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
    if (count == 6) base::refuse("expected base64 in groups of four, found a single character at its end");
    return bytes;
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percentDecoded(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        char character = uri[i];
        if (character == '%') {
            const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
            const int low = i + 2 < uri.size() ? hexDigit(uri[i + 2]) : -1;
            if (high < 0 || low < 0)
                base::refuse("expected two hexadecimal digits after %, found " + base::quote(uri.substr(i)));
            character = static_cast<char>(high * 16 + low);
            i += 2;
        }
        if (character == '\0') base::refuse("expected a file name, found a zero byte in " + base::quote(uri));
        text += character;
    }
    return text;
}

bool hasScheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    return colon != std::string_view::npos && uri.substr(0, colon).find('/') == std::string_view::npos;
}

bool startsWith(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

bool isDataUri(std::string_view uri) noexcept { return uri.starts_with("data:"); }

std::vector<std::uint8_t> decodeDataUri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
        base::refuse("expected a data URI in base64, found " + base::quote(uri));
    return decodeBase64(uri.substr(comma + 1));
}

fs::path fileOfUri(const fs::path& model, std::string_view uri) {
    constexpr std::string_view outside = "expected a file within the model's folder, found ";
    const fs::path relative = percentDecoded(uri);
    if (hasScheme(uri) || relative.is_absolute() || startsWith(relative.lexically_normal(), ".."))
        base::refuse(std::string{outside} + base::quote(uri));

    std::error_code failure;
    const fs::path folder = fs::canonical(model.has_parent_path() ? model.parent_path() : fs::path{"."}, failure);
    const fs::path file = failure ? fs::path{} : fs::canonical(folder / relative, failure);
    if (failure) base::refuse(fmt::format("expected the file {}, found: {}", base::quote(uri), failure.message()));
    if (!startsWith(file, folder))
        base::refuse(std::string{outside} + base::quote(uri) + ", a link that leads out of it");
    return file;
}

}  // namespace inkedge::gltf
