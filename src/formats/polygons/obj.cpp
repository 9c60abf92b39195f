#include "formats/polygons/obj.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/message.h"
#include "formats/text.h"

namespace inkedge::polygons {
namespace {

// The v, vt and vn that a corner names, each counted from 1; 0: none.
struct Vertex {
    std::uint32_t position = 0;
    std::uint32_t texture = 0;
    std::uint32_t normal = 0;
    std::uint32_t next = 0;  // another of the same position, counted from 1
};

class ObjReader {
public:
    ObjReader(std::string_view content, Coordinates coordinates, std::uint64_t limit)
        : rest_{content},
          coordinates_{coordinates},
          limit_{limit},
          maxElements_{std::min<std::uint64_t>(content.size() / shortestLine, limit)} {}

    PolygonFile read() {
        try {
            for (line_ = 1; !rest_.empty(); ++line_) readLine(takeLine());
        } catch (const Error& error) {
            throw Error{error.kind(), base::label("line", line_) + ": " + error.what()};
        }
        base::within(base::label("line", position_.line),
                     [&] { checkIndex(position_, positions_.size(), "a vertex"); });
        base::within(base::label("line", normal_.line), [&] { checkIndex(normal_, normals_.size(), "a normal"); });
        base::within(base::label("line", texture_.line), [&] { checkIndex(texture_, textures_.size(), "a vt"); });
        if (file_.faceCount + file_.points + file_.lines.size() == 0) {
            if (positions_.empty()) base::refuse("expected faces, found none");
            file_.points = positions_.size();
        }
        fillVertices();
        return std::move(file_);
    }

private:
    static constexpr std::size_t shortestLine = 5;  // "vt 0\n"

    // The highest index in a face, and its line.
    struct Highest {
        std::uint64_t number = 0;
        std::size_t line = 0;
    };

    std::string_view takePhysicalLine() {
        std::size_t end = 0;
        while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end);
        rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest_.size(), 1));
        return withoutComment(line);
    }

    // A # starts a comment only at the start of a word: names may hold a #.
    static std::string_view withoutComment(std::string_view line) {
        for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
            if (at == 0 || formats::isBlank(line[at - 1])) return line.substr(0, at);
        return line;
    }

    // A backslash joins a line with the next.
    std::string_view takeLine() {
        std::string_view line = takePhysicalLine();
        if (!line.ends_with('\\')) return line;
        joined_.clear();
        for (;;) {
            const bool goesOn = line.ends_with('\\');
            joined_ += line.substr(0, line.size() - (goesOn ? 1 : 0));
            joined_ += ' ';
            if (!goesOn || rest_.empty()) return joined_;
            ++line_;
            line = takePhysicalLine();
        }
    }

    void readLine(std::string_view line) {
        const std::string_view keyword = formats::takeWord(line);
        if (keyword == "v") {
            positions_.push_back(readVector("v", line));
            return expectWithin(positions_.size(), limit_);
        }
        if (keyword == "vn") return normals_.push_back(glm::vec3{readVector("vn", line)});
        if (keyword == "vt" && coordinates_ == Coordinates::Read) return readTexture(line);
        if (keyword == "f" || keyword == "fo") return readFace(line);
        if (keyword == "usemtl") return useMaterial(line);
        if (keyword == "p") file_.points += countWords(line);
        if (keyword == "l") return readLineElement(line);
    }

    static std::uint64_t countWords(std::string_view line) {
        std::uint64_t count = 0;
        while (!formats::takeWord(line).empty()) ++count;
        return count;
    }

    static bool isFinite(const std::optional<double>& number) {
        return number && std::abs(*number) <= double{std::numeric_limits<float>::max()};
    }

    static glm::dvec3 readVector(std::string_view keyword, std::string_view line) {
        glm::dvec3 vector{0.0};
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = formats::takeWord(line);
            const std::optional<double> number = formats::toNumber<double>(word);
            if (!isFinite(number))
                base::refuse(fmt::format("expected three finite numbers after {}, found {} and {}", keyword, i,
                                         word.empty() ? "no more" : base::quote(word)));
            vector[i] = *number;
        }
        return vector;
    }

    // "vt u", "vt u v" or "vt u v w"; v = 0 lies at the bottom.
    void readTexture(std::string_view line) {
        glm::vec2 texture{0.0F};
        for (int i = 0; i < 2; ++i) {
            const std::string_view word = formats::takeWord(line);
            const std::optional<double> number = i == 1 && word.empty() ? 0.0 : formats::toNumber<double>(word);
            if (!isFinite(number))
                base::refuse(fmt::format("expected one to three finite numbers after vt, found {} and {}", i,
                                         word.empty() ? "no more" : base::quote(word)));
            texture[i] = static_cast<float>(*number);
        }
        textures_.emplace_back(texture.x, 1.0F - texture.y);
    }

    void readFace(std::string_view line) {
        corners_.clear();
        bool allNormals = true;
        bool allTextures = true;
        for (std::string_view word = formats::takeWord(line); !word.empty(); word = formats::takeWord(line)) {
            corners_.push_back(corner(word));
            allNormals = allNormals && corners_.back().normal != 0;
            allTextures = allTextures && corners_.back().texture != 0;
        }
        const bool isFace = corners_.size() >= 3;
        for (Vertex& corner : corners_) {
            if (!allNormals || !isFace) corner.normal = 0;
            if (!allTextures || !isFace) corner.texture = 0;
            file_.corners.push_back(vertexOf(corner));
        }
        file_.endFace(corners_.size(), material_);
        expectWithin(vertices_.size() + file_.corners.size(), limit_);
    }

    void readLineElement(std::string_view line) {
        std::optional<std::uint32_t> before;
        for (std::string_view word = formats::takeWord(line); !word.empty(); word = formats::takeWord(line)) {
            const std::uint32_t vertex = vertexOf({corner(word).position});
            if (before) file_.lines.insert(file_.lines.end(), {*before, vertex});
            before = vertex;
        }
    }

    // The index of the vertex that a corner names; a new vertex if no earlier corner named it. Of a position with very
    // many vertices only the latest are looked at.
    std::uint32_t vertexOf(const Vertex& corner) {
        if (corner.position > firstVertices_.size()) firstVertices_.resize(corner.position, 0);
        std::uint32_t& first = firstVertices_[corner.position - 1];
        constexpr int maxLooked = 32;
        std::uint32_t vertex = first;
        for (int i = 0; vertex != 0 && i < maxLooked; ++i) {
            const Vertex& known = vertices_[vertex - 1];
            if (known.texture == corner.texture && known.normal == corner.normal) return vertex - 1;
            vertex = known.next;
        }
        vertices_.push_back({corner.position, corner.texture, corner.normal, first});
        first = static_cast<std::uint32_t>(vertices_.size());
        return first - 1;
    }

    // "7", "7/8", "7/8/9" or "7//9".
    Vertex corner(std::string_view word) {
        const std::string_view whole = word;
        const std::string_view position = takePart(word);
        const std::string_view texture = takePart(word);
        const std::string_view normal = takePart(word);
        if (!word.empty() || (!texture.empty() && !formats::toNumber<std::int64_t>(texture)))
            base::refuse("expected a corner like 7, 7/8, 7/8/9 or 7//9, found " + base::quote(whole));
        Vertex found;
        found.position = index(position, positions_.size(), "a vertex", position_);
        if (!normal.empty()) found.normal = index(normal, normals_.size(), "a normal", normal_);
        if (!texture.empty() && coordinates_ == Coordinates::Read)
            found.texture = index(texture, textures_.size(), "a vt", texture_);
        return found;
    }

    static std::string_view takePart(std::string_view& word) {
        const std::string_view part = word.substr(0, word.find('/'));
        word.remove_prefix(std::min(part.size() + 1, word.size()));
        return part;
    }

    // An index counted from 1. Negative indices count back from the last element so far. Positive ones may name an
    // element that comes later: the highest is checked at the end. An index that no file of this size can have is only
    // noted.
    std::uint32_t index(std::string_view text, std::uint64_t count, std::string_view kind, Highest& highest) const {
        const std::optional<std::int64_t> number = formats::toNumber<std::int64_t>(text);
        if (!number) base::refuse(fmt::format("expected the number of {}, found {}", kind, base::quote(text)));
        const std::int64_t counted = *number < 0 ? static_cast<std::int64_t>(count) + 1 + *number : *number;
        if (counted <= 0)
            base::refuse(fmt::format("expected {} from 1 or from -1 to -{}, found {}", kind, count, *number));
        const auto found = static_cast<std::uint64_t>(counted);
        if (found > highest.number) highest = {found, line_};
        return found > maxElements_ ? 1 : static_cast<std::uint32_t>(found);
    }

    static void checkIndex(const Highest& highest, std::uint64_t count, std::string_view kind) {
        if (highest.number > count)
            base::refuse(fmt::format("expected {} from 1 to {}, found {}", kind, count, highest.number));
    }

    void useMaterial(std::string_view line) {
        const auto next = static_cast<std::uint32_t>(materials_.size() + 1);
        material_ = materials_.try_emplace(std::string{formats::takeWord(line)}, next).first->second;
    }

    // Fills the vertices, once all elements are known.
    void fillVertices() {
        const auto has = [&](std::uint32_t Vertex::*part) {
            return std::ranges::any_of(vertices_, [&](const Vertex& vertex) { return vertex.*part != 0; });
        };
        const std::size_t count = vertices_.size();
        file_.finePositions.resize(count);
        file_.normals.resize(has(&Vertex::normal) ? count : 0, glm::vec3{0.0F});
        file_.textureCoordinates.resize(has(&Vertex::texture) ? count : 0, glm::vec2{0.0F});
        for (std::size_t i = 0; i < count; ++i) {
            const Vertex& vertex = vertices_[i];
            file_.finePositions[i] = positions_[vertex.position - 1];
            if (vertex.normal != 0) file_.normals[i] = normals_[vertex.normal - 1];
            if (vertex.texture != 0) file_.textureCoordinates[i] = textures_[vertex.texture - 1];
        }
    }

    std::string_view rest_;
    Coordinates coordinates_;
    std::uint64_t limit_;
    std::uint64_t maxElements_;  // of a kind that the file can hold
    PolygonFile file_;
    std::size_t line_ = 0;
    std::string joined_;
    std::vector<glm::dvec3> positions_;
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec2> textures_;
    Highest position_;
    Highest normal_;
    Highest texture_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> firstVertices_;  // one per position: counted from 1, 0: none
    std::vector<Vertex> corners_;               // of the face at hand
    std::map<std::string, std::uint32_t> materials_;
    std::uint32_t material_ = 0;
};

}  // namespace

PolygonFile readObj(std::string_view content, Coordinates coordinates, std::uint64_t maxElements) {
    if (formats::isUtf16(content)) base::refuse("expected OBJ, found UTF-16 text: save it as UTF-8");
    if (const std::size_t zero = content.find('\0'); zero != std::string_view::npos)
        base::refuse(fmt::format("expected OBJ, found a zero byte at byte {}", zero));
    return ObjReader{formats::withoutByteOrderMark(content), coordinates, maxElements}.read();
}

}  // namespace inkedge::polygons
