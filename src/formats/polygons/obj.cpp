#include "formats/polygons/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/message.h"
#include "formats/text.h"

namespace inkedge::load {
namespace {

class Checker {
public:
    Checker(const glm::dvec3& origin, Coordinates coordinates) : origin_{origin}, coordinates_{coordinates} {}

    ObjContent check(std::string_view content) {
        content_.text.reserve(content.size() + 64);
        for (line_ = 1; !content.empty(); ++line_) {
            const std::string_view line = takeLine(content);
            if (!line.empty()) within(label("line", line_), [&] { readLine(line); });
        }
        within(label("line", highest_.line), [&] { checkIndex(highest_.vertex, vertices_, "a vertex"); });
        within(label("line", highest_.normalLine), [&] { checkIndex(highest_.normal, normals_, "a normal"); });
        within(label("line", highest_.textureLine), [&] { checkIndex(highest_.texture, textures_, "a vt"); });
        return std::move(content_);
    }

private:
    // A backslash joins a line with the next.
    std::string_view takeLine(std::string_view& rest) {
        std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) end = rest.size();
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (!line.ends_with('\\')) return line;
        joined_.assign(line.substr(0, line.size() - 1));
        while (line.ends_with('\\') && !rest.empty()) {
            ++line_;
            end = std::min(rest.find('\n'), rest.size());
            line = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (line.ends_with('\r')) line.remove_suffix(1);
            joined_ += ' ';
            joined_ += line.substr(0, line.size() - (line.ends_with('\\') ? 1 : 0));
        }
        return joined_;
    }

    void readLine(std::string_view line) {
        const std::string_view keyword = takeWord(line);
        if (keyword == "v") return readVector("v", line, origin_, vertices_);
        if (keyword == "vn") return readVector("vn", line, glm::dvec3{0.0}, normals_);
        if (keyword == "vt" && coordinates_ == Coordinates::Read) return readTexture(line);
        if (keyword == "f" || keyword == "fo") return readFace(line);
        if (keyword == "usemtl") return useMaterial(line);
        if (keyword == "p") content_.points += countWords(line);
        if (keyword == "l") content_.lines += std::max<std::uint64_t>(countWords(line), 1) - 1;
    }

    static std::uint64_t countWords(std::string_view line) {
        std::uint64_t count = 0;
        while (!takeWord(line).empty()) ++count;
        return count;
    }

    void readVector(std::string_view keyword, std::string_view line, const glm::dvec3& origin, std::uint64_t& count) {
        write(keyword);
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = takeWord(line);
            const std::optional<double> number = toNumber<double>(word);
            if (!number || !(std::abs(*number) <= std::numeric_limits<float>::max()))
                refuse(fmt::format("expected three finite numbers after {}, found {} and {}", keyword, i,
                                   word.empty() ? "no more" : quote(word)));
            write(" ");
            write(static_cast<float>(*number - origin[i]));
        }
        write("\n");
        ++count;
    }

    // "vt u", "vt u v" or "vt u v w".
    void readTexture(std::string_view line) {
        write("vt");
        for (int i = 0; i < 2; ++i) {
            const std::string_view word = takeWord(line);
            const std::optional<double> number = i == 1 && word.empty() ? 0.0 : toNumber<double>(word);
            if (!number || !(std::abs(*number) <= std::numeric_limits<float>::max()))
                refuse(fmt::format("expected one to three finite numbers after vt, found {} and {}", i,
                                   word.empty() ? "no more" : quote(word)));
            write(" ");
            write(static_cast<float>(*number));
        }
        write("\n");
        ++textures_;
    }

    void readFace(std::string_view line) {
        corners_.clear();
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line))
            corners_.push_back(corner(word));
        if (corners_.size() < 3) {
            ++(corners_.size() == 2 ? content_.lines : content_.points);
            return;
        }
        const bool allNormals = std::ranges::all_of(corners_, [](const Corner& c) { return c.normal != 0; });
        const bool allTextures = std::ranges::all_of(corners_, [](const Corner& c) { return c.texture != 0; });
        write("f");
        for (const Corner& c : corners_) {
            write(" ");
            write(fmt::format_int{c.vertex});
            if (allTextures || allNormals) write("/");
            if (allTextures) write(fmt::format_int{c.texture});
            if (!allNormals) continue;
            write("/");
            write(fmt::format_int{c.normal});
        }
        write("\n");
        content_.faceMaterials.push_back(material_);
    }

    struct Corner {
        std::uint64_t vertex = 0;
        std::uint64_t normal = 0;   // 0: none
        std::uint64_t texture = 0;  // 0: none, or of no use
    };

    // "7", "7/8", "7/8/9" or "7//9".
    Corner corner(std::string_view word) {
        const std::string_view whole = word;
        const std::string_view vertex = takePart(word);
        const std::string_view texture = takePart(word);
        const std::string_view normal = takePart(word);
        if (!word.empty() || (!texture.empty() && !toNumber<std::int64_t>(texture)))
            refuse("expected a corner like 7, 7/8, 7/8/9 or 7//9, found " + quote(whole));
        const Corner found{
            index(vertex, vertices_, "a vertex"), normal.empty() ? 0 : index(normal, normals_, "a normal"),
            texture.empty() || coordinates_ == Coordinates::Skip ? 0 : index(texture, textures_, "a vt")};
        if (found.vertex > highest_.vertex) highest_.vertex = found.vertex, highest_.line = line_;
        if (found.normal > highest_.normal) highest_.normal = found.normal, highest_.normalLine = line_;
        if (found.texture > highest_.texture) highest_.texture = found.texture, highest_.textureLine = line_;
        return found;
    }

    static std::string_view takePart(std::string_view& word) {
        const std::string_view part = word.substr(0, word.find('/'));
        word.remove_prefix(std::min(part.size() + 1, word.size()));
        return part;
    }

    // Counted from 1; negative ones from the last so far. Positive ones may lie ahead.
    static std::uint64_t index(std::string_view text, std::uint64_t count, std::string_view kind) {
        const std::optional<std::int64_t> number = toNumber<std::int64_t>(text);
        if (!number) refuse(fmt::format("expected the number of {}, found {}", kind, quote(text)));
        const std::int64_t place = *number < 0 ? static_cast<std::int64_t>(count) + 1 + *number : *number;
        if (place <= 0) refuse(fmt::format("expected {} from 1 or from -1 to -{}, found {}", kind, count, *number));
        return static_cast<std::uint64_t>(place);
    }

    static void checkIndex(std::uint64_t highest, std::uint64_t count, std::string_view kind) {
        if (highest > count) refuse(fmt::format("expected {} from 1 to {}, found {}", kind, count, highest));
    }

    void useMaterial(std::string_view line) {
        const auto next = static_cast<std::uint32_t>(materials_.size() + 1);
        material_ = materials_.try_emplace(std::string{takeWord(line)}, next).first->second;
    }

    void write(std::string_view text) { content_.text.insert(content_.text.end(), text.begin(), text.end()); }
    // In plain form: assimp does not take .5 for a number.
    void write(float number) {
        std::array<char, 32> text{};
        const char* const end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
        write(std::string_view{text.data(), static_cast<std::size_t>(end - text.data())});
    }
    void write(const fmt::format_int& number) { write(std::string_view{number.data(), number.size()}); }

    // The highest numbers in faces, and where they stand.
    struct Highest {
        std::uint64_t vertex = 0;
        std::size_t line = 0;
        std::uint64_t normal = 0;
        std::size_t normalLine = 0;
        std::uint64_t texture = 0;
        std::size_t textureLine = 0;
    };

    glm::dvec3 origin_;
    Coordinates coordinates_;
    ObjContent content_;
    std::size_t line_ = 0;
    std::string joined_;
    std::uint64_t vertices_ = 0;
    std::uint64_t normals_ = 0;
    std::uint64_t textures_ = 0;
    Highest highest_;
    std::vector<Corner> corners_;  // of the face at hand
    std::map<std::string, std::uint32_t> materials_;
    std::uint32_t material_ = 0;
};

}  // namespace

ObjContent checkedObj(std::string_view content, const glm::dvec3& origin, Coordinates coordinates) {
    if (const std::size_t zero = content.find('\0'); zero != std::string_view::npos)
        refuse(fmt::format("expected OBJ, found a zero byte at byte {}", zero));
    return Checker{origin, coordinates}.check(content);
}

}  // namespace inkedge::load
