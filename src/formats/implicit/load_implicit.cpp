#include "formats/implicit/load_implicit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <inkedge/setting_table.h>

#include "base/message.h"
#include "formats/cad/fineness.h"
#include "formats/implicit/field.h"
#include "formats/implicit/field_surface.h"
#include "formats/implicit/polygonise.h"
#include "formats/text.h"

namespace inkedge::implicit {
namespace {

constexpr std::size_t longestExpression = 10'000;  // characters

struct Surface {
    std::optional<Box> bounds;
    LengthUnit unit = LengthUnit::None;
    std::string expression;
};

// Takes a text apart, line by line.
class Parser {
public:
    Surface parse(std::string_view text) {
        text = formats::withoutByteOrderMark(text);
        while (!text.empty()) {
            ++line_;
            const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
            takeLine(text.substr(0, std::min(end, text.find('#'))));
            const bool isPair = text.substr(end).starts_with("\r\n");
            text.remove_prefix(std::min(end + (isPair ? 2 : 1), text.size()));
        }
        if (!surface_.bounds) base::refuse("expected a line of bounds, as in 'bounds -1 -1 -1 1 1 1', found none");
        if (surface_.expression.empty())
            base::refuse("expected a line of f, as in 'f = x^2 + y^2 + z^2 - 1', found none");
        return std::move(surface_);
    }

private:
    void takeLine(std::string_view line) {
        if (formats::trimmed(line).empty()) return;
        if (formats::isBlank(line.front()) && !surface_.expression.empty()) return addToExpression(line);
        std::string_view rest = line;
        const std::string_view word = formats::takeWord(rest);
        if (word == "bounds") return takeBounds(rest);
        if (word == "unit") return takeUnit(formats::takeWord(rest));
        rest = formats::trimmed(line);
        if (rest.starts_with('f')) {
            rest = formats::trimmed(rest.substr(1));
            if (rest.starts_with('=') && surface_.expression.empty()) return addToExpression(rest.substr(1));
        }
        refuse(line, "bounds, unit or f =, each once");
    }

    void addToExpression(std::string_view text) {
        surface_.expression += text;
        surface_.expression += ' ';
        if (surface_.expression.size() > longestExpression)
            base::refuse(fmt::format("expected an expression of at most {} characters, found more", longestExpression));
    }

    void takeBounds(std::string_view rest) {
        Box box;
        for (glm::dvec3* const side : {&box.min, &box.max}) {
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view word = formats::takeWord(rest);
                const std::optional<double> number = formats::toNumber<double>(word);
                if (!number || !(std::abs(*number) < maxCoordinate))
                    refuse(word, "six numbers under 1e30 after bounds");
                (*side)[axis] = *number;
            }
        }
        for (int axis = 0; axis < 3; ++axis)
            if (!(box.min[axis] < box.max[axis]))
                refuse(fmt::format("{:g} and {:g}", box.min[axis], box.max[axis]),
                       "bounds of which the first three are less than the others");
        if (surface_.bounds || !formats::trimmed(rest).empty()) refuse(rest, "bounds once, with six numbers");
        surface_.bounds = box;
    }

    // As --unit takes it.
    void takeUnit(std::string_view word) {
        Settings settings;
        try {
            findSetting("unit")->set(settings, word);
        } catch (const Error& error) {
            base::refuse(fmt::format("unit in line {}: {}", line_, error.what()));
        }
        surface_.unit = settings.load.unit;
    }

    [[noreturn]] void refuse(std::string_view found, std::string_view expected) const {
        base::refuse(fmt::format("expected {}, found {} in line {}", expected, base::quote(found), line_));
    }

    static constexpr double maxCoordinate = 1e30;
    std::size_t line_ = 0;
    Surface surface_;
};

// A field that may be asked for so long.
class TimedField final : public ScalarField {
public:
    TimedField(const ScalarField& field, double seconds) : field_{field}, seconds_{seconds} {}

    void evaluate(std::span<const glm::dvec3> at, std::span<double> values) const override {
        const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start_;
        if (past.count() > seconds_)
            base::refuse(
                fmt::format("expected triangles of the surface within {:.4g} s, found it still at work; raise "
                            "max-reading-time or tolerance",
                            seconds_));
        field_.evaluate(at, values);
    }

private:
    const ScalarField& field_;
    double seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

constexpr glm::dvec3 zUp{0.0, 0.0, 1.0};

double deflectionIn(const Box& box, const LoadSettings& settings) {
    cad::Outline outline;
    std::vector<glm::dvec3>& corners = outline.parts.emplace_back();
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1) != 0 ? box.max.x : box.min.x, (k & 2) != 0 ? box.max.y : box.min.y,
                             (k & 4) != 0 ? box.max.z : box.min.z);
    outline.instances.emplace_back();
    return cad::finenessFor(outline, settings.up.value_or(zUp), settings).deflections.front();
}

// Far less than what polygonise() sees.
double differenceIn(const Box& box) {
    const glm::dvec3 size = box.max - box.min;
    return 2e-5 * std::max({size.x, size.y, size.z});
}

}  // namespace

Scene::Data loadImplicit(const formats::ModelInput& input, const LoadSettings& settings) {
    return base::within(input.where(), [&] {
        std::uint64_t bytesLeft = settings.limits.fileSize;
        const formats::Content content{input, bytesLeft};
        const Surface surface = Parser{}.parse(base::textOf(content.bytes()));
        const std::shared_ptr<const ScalarField> field = fieldOf(surface.expression);
        const Grain grain{*surface.bounds, deflectionIn(*surface.bounds, settings), settings.limits.vertices};
        Scene::Data data;
        data.source.unit = surface.unit;
        data.meshes.push_back(polygonise(TimedField{*field, settings.limits.readingTime}, grain));
        data.meshes.back().name = input.name.stem().string();
        data.meshes.back().surfaces = std::make_shared<const FieldSurface>(field, differenceIn(*surface.bounds));
        data.instances.emplace_back().name = data.meshes.back().name;
        return data;
    });
}

}  // namespace inkedge::implicit
