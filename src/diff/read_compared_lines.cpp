#include <inkedge/compare_lines.h>

#include <cstdint>
#include <string_view>
#include <utility>

#include <inkedge/read_lines.h>

#include "base/message.h"
#include "base/read_file.h"
#include "diff/svg_lines.h"
#include "io/read_picture.h"

namespace inkedge {
namespace {

constexpr std::uint64_t largestSvg = std::uint64_t{1} << 30U;  // bytes

// The first character that is no blank, after a mark of UTF-8.
char firstOf(std::string_view start) {
    if (start.starts_with("\xEF\xBB\xBF")) start.remove_prefix(3);
    const std::size_t at = start.find_first_not_of(" \t\r\n");
    return at == std::string_view::npos ? '\0' : start[at];
}

}  // namespace

ComparedLines readComparedLines(const std::filesystem::path& file) {
    constexpr std::size_t enough = 64;
    const base::Bytes start =
        base::within(base::printable(file.string()), [&] { return base::readStart(file, enough); });
    switch (firstOf(base::textOf(start))) {
        case '{':
            return comparedLines(readLines(file));
        case '<':
            return base::within(base::printable(file.string()), [&] {
                std::uint64_t bytesLeft = largestSvg;
                return diff::linesOfSvg(base::textOf(base::readBytes(file, bytesLeft)));
            });
        default:
            return comparedLines(io::readPicture(file).image);
    }
}

}  // namespace inkedge
