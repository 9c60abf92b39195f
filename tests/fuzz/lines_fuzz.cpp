// Bytes as a file of lines, JSON or SVG. What is read can be written, and what is written reads back the same.
#include <inkedge/read_lines.h>
#include <inkedge/write.h>

#include "diff/svg_lines.h"
#include "fuzz/promise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace inkedge;
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    fuzz::mayBeRefused([&] { static_cast<void>(diff::linesOfSvg(text)); });
    fuzz::mayBeRefused([&] {
        const Lines lines = linesFromJson(text);
        Settings settings;
        settings.lines.hidden = HiddenLines::Solid;
        const std::string once = linesJson(lines, settings);
        const std::string twice = linesJson(linesFromJson(once), settings);
        fuzz::expect(once == twice, once, twice);
        static_cast<void>(linesSvg(lines, settings));
    });
    return 0;
}
