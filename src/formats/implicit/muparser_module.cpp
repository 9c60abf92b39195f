#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <muParser.h>

#include <inkedge/export.h>

#include "base/message.h"
#include "formats/implicit/field.h"

namespace inkedge::implicit {
namespace {

// What one thread at a time evaluates with.
class Parser {
public:
    explicit Parser(const std::string& expression) {
        parser_.DefineVar("x", &at_.x);
        parser_.DefineVar("y", &at_.y);
        parser_.DefineVar("z", &at_.z);
        parser_.SetExpr(expression);
    }

    double value(glm::dvec3 at) {
        at_ = at;
        return parser_.Eval();
    }

    [[nodiscard]] int results() const { return parser_.GetNumResults(); }

private:
    mu::Parser parser_;
    glm::dvec3 at_{0.0};
};

class Expression final : public ScalarField {
public:
    explicit Expression(std::string text) : text_{std::move(text)} {
        auto parser = std::make_unique<Parser>(text_);
        static_cast<void>(parser->value(glm::dvec3{0.0}));
        if (parser->results() != 1)
            throw std::runtime_error{fmt::format("expected one value of f, found {}", parser->results())};
        idle_.push_back(std::move(parser));
    }

    void evaluate(std::span<const glm::dvec3> at, std::span<double> values) const override {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        try {
            std::unique_ptr<Parser> parser = taken();
            for (std::size_t i = 0; i < at.size(); ++i) values[i] = parser->value(at[i]);
            const std::lock_guard lock{mutex_};
            idle_.push_back(std::move(parser));
        } catch (const mu::ParserError&) {
            std::ranges::fill(values, none);
        }
    }

private:
    // To read a long text takes longer than to evaluate it.
    std::unique_ptr<Parser> taken() const {
        {
            const std::lock_guard lock{mutex_};
            if (!idle_.empty()) {
                std::unique_ptr<Parser> parser = std::move(idle_.back());
                idle_.pop_back();
                return parser;
            }
        }
        return std::make_unique<Parser>(text_);
    }

    std::string text_;
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<Parser>> idle_;
};

CompiledField compile(const std::string& expression) {
    try {
        return {std::make_shared<Expression>(expression), {}};
    } catch (const mu::ParserError& error) {
        throw std::runtime_error{"expected an expression of x, y and z, found: " + base::printable(error.GetMsg())};
    }
}

}  // namespace

extern "C" INKEDGE_API const ExpressionFunctions* inkedge_muparser_1() noexcept {
    static constexpr ExpressionFunctions functions{
        [](const std::string& expression) { return modules::guarded([&] { return compile(expression); }); }};
    return &functions;
}

}  // namespace inkedge::implicit
