#include "formats/cad/file_ends.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/message.h"
#include "base/read_file.h"
#include "formats/cad/zip_directory.h"
#include "formats/text.h"

namespace inkedge::cad {
namespace {

constexpr std::size_t lookedAt = 4096;  // bytes

std::string_view end(std::string_view text) { return text.substr(text.size() - std::min(text.size(), lookedAt)); }

[[noreturn]] void refuse(std::string_view expected, std::string_view text) {
    base::refuse(fmt::format("expected {}, found {}", expected, base::kindOf(text)));
}

// Comments may stand anywhere between.
std::string_view withoutComments(std::string_view text) {
    text = formats::trimmed(formats::withoutByteOrderMark(text));
    while (text.starts_with("/*")) {
        const std::size_t end = text.find("*/");
        if (end == std::string_view::npos) break;
        text = formats::trimmed(text.substr(end + 2));
    }
    return text;
}

void expectStep(std::string_view text) {
    if (!withoutComments(text).starts_with("ISO-10303-21")) refuse("ISO-10303-21 first in a STEP file", text);
    if (end(text).find("END-ISO-10303-21") == std::string_view::npos)
        base::refuse("expected END-ISO-10303-21 last in a STEP file, found none: it is cut short");
}

// The letter of a line's section, in its column 73.
char sectionOf(std::string_view line) { return line.size() > 72 ? line[72] : '\0'; }

void expectIges(std::string_view text) {
    const char first = sectionOf(text.substr(0, text.find_first_of("\r\n")));
    if (first != 'S' && first != 'C' && first != 'B')
        refuse("lines of 80 characters, of section S first, in an IGES file", text);
    std::string_view rest = end(text);
    while (!rest.empty() && formats::isBlank(rest.back())) rest.remove_suffix(1);
    const std::size_t line = rest.find_last_of("\r\n");
    if (sectionOf(line == std::string_view::npos ? rest : rest.substr(line + 1)) != 'T')
        base::refuse("expected a line of section T last in an IGES file, found none: it is cut short");
}

// Of text: the orientation and the number of the shape that stands for all, and the number of its location.
bool isShape(std::string_view line) {
    if (line.empty() || std::string_view{"+-ie"}.find(line.front()) == std::string_view::npos) return false;
    line.remove_prefix(1);
    return formats::toNumber<unsigned>(formats::takeWord(line)) && formats::toNumber<unsigned>(formats::takeWord(line));
}

// It is the last line; DRAW writes a 0 after it.
bool endsWithShape(std::string_view text) {
    std::string_view rest = end(text);
    for (int lines = 0; lines < 2; ++lines) {
        while (!rest.empty() && formats::isBlank(rest.back())) rest.remove_suffix(1);
        const std::size_t before = rest.find_last_of("\r\n");
        if (before == std::string_view::npos) return false;
        const std::string_view line = rest.substr(before + 1);
        if (isShape(line)) return true;
        if (line != "0") return false;
        rest = rest.substr(0, before);
    }
    return false;
}

void expectBrep(std::string_view text) {
    const std::string_view start = formats::trimmed(text.substr(0, lookedAt));
    const bool known = start.starts_with("DBRep_DrawableShape") || start.starts_with("CASCADE Topology V") ||
                       start.starts_with("Open CASCADE Topology V");
    if (!known) refuse("'DBRep_DrawableShape' or 'CASCADE Topology' first in a BREP file", text);
    if (!start.starts_with("Open CASCADE") && !endsWithShape(text))
        base::refuse("expected the number of a shape, as in '+1 0', last in a BREP file, found none: it is cut short");
}

void expectThreeMf(std::string_view text, std::uint64_t maxUnpacked) {
    if (!text.starts_with("PK")) refuse("a ZIP archive in a 3MF file", text);
    std::uint64_t left = maxUnpacked;
    const std::span archive{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
    const std::vector<ZipEntry> entries = zipDirectory(archive);
    for (const std::string_view name : {"[Content_Types].xml", "_rels/.rels"})
        if (std::ranges::find(entries, name, &ZipEntry::name) == entries.end())
            base::refuse(fmt::format("expected {} in a 3MF file, found a ZIP archive without it", name));
    for (const ZipEntry& entry : entries) {
        if (entry.size > left)
            base::refuse(fmt::format("expected at most {} bytes in the files of a 3MF, found more; raise max-file-size",
                                     maxUnpacked));
        left -= entry.size;
    }
}

}  // namespace

std::string_view nameOf(FileKind kind) noexcept {
    switch (kind) {
        case FileKind::Step:
            return "STEP";
        case FileKind::Iges:
            return "IGES";
        case FileKind::Brep:
            return "BREP";
        case FileKind::ThreeMf:
            break;
    }
    return "3MF";
}

void expectWhole(std::string_view text, FileKind kind, std::uint64_t maxUnpacked) {
    switch (kind) {
        case FileKind::Step:
            return expectStep(text);
        case FileKind::Iges:
            return expectIges(text);
        case FileKind::Brep:
            return expectBrep(text);
        case FileKind::ThreeMf:
            return expectThreeMf(text, maxUnpacked);
    }
}

}  // namespace inkedge::cad
