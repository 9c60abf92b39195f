#include "formats/gltf/animation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "formats/text.h"

namespace inkedge::gltf {

namespace {

const Expected keyTimes{scalar, {Component::Float}};
const Expected vectors{vec3, {Component::Float}};
const Expected rotations{vec4,
                         {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
const Expected weights{scalar,
                       {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};

constexpr std::size_t longestList = 10;  // of animations in a message

const tinygltf::Animation& find(const tinygltf::Model& model, std::string_view wanted) {
    const auto named = std::ranges::find(model.animations, wanted, &tinygltf::Animation::name);
    if (named != model.animations.end()) return *named;
    const std::optional<std::size_t> number = formats::toNumber<std::size_t>(wanted);
    if (number && *number < model.animations.size()) return model.animations[*number];
    std::string list;
    for (std::size_t i = 0; i < std::min(model.animations.size(), longestList); ++i)
        list += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, base::quote(model.animations[i].name));
    if (model.animations.size() > longestList) list += ", ...";
    throw Error{Error::Kind::Usage, fmt::format("animation: expected {}, found {}",
                                                list.empty() ? "none, as the file has no animations" : "one of " + list,
                                                base::quote(wanted))};
}

// The keys before and after a time, and how far the time is from the one to the other.
struct Moment {
    std::size_t before;
    std::size_t after;
    double share;  // 0 to 1
    double step;   // seconds between the keys
};

Moment momentAt(const std::vector<double>& times, double time) {
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
    if (next == 0) return {0, 0, 0.0, 0.0};
    if (next == times.size()) return {next - 1, next - 1, 0.0, 0.0};
    const double step = times[next] - times[next - 1];
    return {next - 1, next, (time - times[next - 1]) / step, step};
}

// The value of a sampler at a time: `width` numbers.
class Sampler {
public:
    Sampler(const tinygltf::Model& model, const tinygltf::AnimationSampler& source, const Expected& expected)
        : times_{readNumbers(model, source.input, "input", keyTimes)},
          values_{readNumbers(model, source.output, "output", expected)},
          cubic_{source.interpolation == "CUBICSPLINE"},
          step_{source.interpolation == "STEP"} {
        if (!cubic_ && !step_ && source.interpolation != "LINEAR")
            base::refuse("expected interpolation LINEAR, STEP or CUBICSPLINE, found " +
                         base::quote(source.interpolation));
        if (times_.empty()) base::refuse("expected keys, found none");
        for (std::size_t i = 0; i < times_.size(); ++i)
            if (!std::isfinite(times_[i]) || (i > 0 && !(times_[i] > times_[i - 1])))
                base::refuse(fmt::format("expected times that rise, found {} at key {}", times_[i], i));
        const std::size_t parts = times_.size() * (cubic_ ? 3 : 1);
        width_ = values_.size() / parts;
        if (width_ == 0 || values_.size() != width_ * parts)
            base::refuse(fmt::format("expected the same number of values for each of {} keys, found {} in all",
                                     times_.size(), values_.size()));
        for (const double value : values_)
            if (!std::isfinite(value)) base::refuse("expected finite values, found one that is not");
    }

    [[nodiscard]] std::vector<double> at(double time, bool rotation) const {
        const Moment m = momentAt(times_, time);
        std::vector<double> result(width_);
        for (std::size_t i = 0; i < width_; ++i) {
            const double a = value(m.before, i);
            const double b = value(m.after, i);
            if (step_)
                result[i] = a;
            else if (cubic_)
                result[i] = hermite(m, i);
            else
                result[i] = a + m.share * (b - a);
        }
        if (rotation && !cubic_ && !step_) slerp(m, result);
        return result;
    }

private:
    // A key of a cubic spline has its in-tangent, its value and its out-tangent.
    [[nodiscard]] double number(std::size_t key, std::size_t part, std::size_t i) const {
        return values_[(cubic_ ? 3 * key + part : key) * width_ + i];
    }
    [[nodiscard]] double value(std::size_t key, std::size_t i) const { return number(key, 1, i); }

    [[nodiscard]] double hermite(const Moment& m, std::size_t i) const {
        const double t = m.share;
        const double t2 = t * t;
        const double t3 = t2 * t;
        return (2 * t3 - 3 * t2 + 1) * value(m.before, i) + m.step * (t3 - 2 * t2 + t) * number(m.before, 2, i) +
               (-2 * t3 + 3 * t2) * value(m.after, i) + m.step * (t3 - t2) * number(m.after, 0, i);
    }

    void slerp(const Moment& m, std::vector<double>& result) const {
        const auto quaternion = [&](std::size_t key) {
            return glm::normalize(glm::dquat{value(key, 3), value(key, 0), value(key, 1), value(key, 2)});
        };
        const glm::dquat q = glm::slerp(quaternion(m.before), quaternion(m.after), m.share);
        if (std::isfinite(q.x + q.y + q.z + q.w)) result = {q.x, q.y, q.z, q.w};
    }

    std::vector<double> times_;
    std::vector<double> values_;
    bool cubic_;
    bool step_;
    std::size_t width_ = 0;
};

// Sets a node to what a channel says at a time; false if the channel drives something that is not read.
bool apply(tinygltf::Model& model, const tinygltf::Animation& animation, const tinygltf::AnimationChannel& channel,
           double time) {
    struct Target {
        std::string_view path;
        const Expected& expected;
        std::size_t width;  // 0: any
        std::vector<double> tinygltf::Node::*member;
    };
    static const Target targets[]{{"translation", vectors, 3, &tinygltf::Node::translation},
                                  {"rotation", rotations, 4, &tinygltf::Node::rotation},
                                  {"scale", vectors, 3, &tinygltf::Node::scale},
                                  {"weights", weights, 0, &tinygltf::Node::weights}};
    const auto* const target = std::ranges::find(targets, channel.target_path, &Target::path);
    if (target == std::end(targets)) return false;
    if (channel.target_node == -1) return true;
    static_cast<void>(at(model.nodes, channel.target_node, "a node"));
    const Sampler sampler{model, at(animation.samplers, channel.sampler, "a sampler"), target->expected};
    std::vector<double> values = sampler.at(time, target->path == "rotation");
    if (target->width != 0 && values.size() != target->width)
        base::refuse(fmt::format("expected {} numbers a key, found {}", target->width, values.size()));
    tinygltf::Node& node = model.nodes[static_cast<std::size_t>(channel.target_node)];
    if (target->width != 0) node.matrix.clear();  // which an animated node must not have
    node.*(target->member) = std::move(values);
    return true;
}

}  // namespace

std::vector<std::string> poseNodes(tinygltf::Model& model, std::string_view wanted, double time) {
    const tinygltf::Animation& animation = find(model, wanted);
    const auto number = static_cast<std::size_t>(&animation - model.animations.data());
    const std::string who = base::label("animation", number, animation.name);
    std::size_t unread = 0;
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
        base::within(who + ", " + base::label("channel", i), [&] {
            if (!apply(model, animation, animation.channels[i], time)) ++unread;
        });
    }
    if (unread == 0) return {};
    return {fmt::format("{}: {} of {} channels drive what is not read", who, unread, animation.channels.size())};
}

}  // namespace inkedge::gltf
