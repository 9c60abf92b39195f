#include "formats/gltf/animation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "formats/gltf/animation_target.h"
#include "formats/gltf/nodes.h"
#include "formats/text.h"

namespace inkedge::gltf {

namespace {

const Expected keyTimes{scalar, {Component::Float}};
const Expected vectors{vec3, {Component::Float}};
const Expected rotations{vec4,
                         {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
const Expected weights{scalar,
                       {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
const Expected booleans{scalar, {Component::Uint8}};

// What KHR_animation_pointer allows for floats.
constexpr std::initializer_list<Component> anyNumber{Component::Float, Component::Int8,   Component::Uint8,
                                                     Component::Int16, Component::Uint16, Component::Uint32};

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
    throw Error{Error::Kind::Usage, fmt::format("--animation: expected {}, found {}",
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

// How values between two keys are found where the interpolation is LINEAR. Booleans step in any.
enum class Between { Straight, Turned, Stepped };

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

    [[nodiscard]] std::vector<double> at(double time, Between between) const {
        const Moment m = momentAt(times_, time);
        std::vector<double> result(width_);
        for (std::size_t i = 0; i < width_; ++i) {
            const double a = value(m.before, i);
            const double b = value(m.after, i);
            if (step_ || between == Between::Stepped)
                result[i] = a;
            else if (cubic_)
                result[i] = hermite(m, i);
            else
                result[i] = a + m.share * (b - a);
        }
        if (between == Between::Turned && !cubic_ && !step_) slerp(m, result);
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

using Property = AnimationTarget::Property;

// A property of a node that is a fixed number of floats.
struct Vector {
    Property property;
    const Expected& expected;
    std::vector<double> tinygltf::Node::*member;
};
const Vector nodeVectors[]{{Property::Translation, vectors, &tinygltf::Node::translation},
                           {Property::Rotation, rotations, &tinygltf::Node::rotation},
                           {Property::Scale, vectors, &tinygltf::Node::scale}};

void setVector(tinygltf::Node& node, const Vector& vector, std::vector<double> values) {
    if (values.size() != vector.expected.type.components)
        base::refuse(
            fmt::format("expected {} numbers a key, found {}", vector.expected.type.components, values.size()));
    node.matrix.clear();  // which an animated node must not have
    node.*(vector.member) = std::move(values);
}

// The weights that a target drives, as many as there are morph targets if it is one of them that is driven.
std::vector<double>& weightsOf(tinygltf::Model& model, const AnimationTarget& target) {
    const auto index = static_cast<std::size_t>(target.index);
    const int meshIndex = target.ofMesh ? target.index : model.nodes[index].mesh;
    std::vector<double>& all = target.ofMesh ? model.meshes[index].weights : model.nodes[index].weights;
    if (!target.element) return all;
    const tinygltf::Mesh& mesh = at(model.meshes, meshIndex, "a mesh");
    const std::size_t count = mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
    if (*target.element >= count)
        base::refuse(fmt::format("expected a weight below {}, found {}", count, *target.element));
    if (all.empty()) all = mesh.weights;
    all.resize(std::max(all.size(), count));
    return all;
}

void setWeights(tinygltf::Model& model, const AnimationTarget& target, std::vector<double> values) {
    std::vector<double>& all = weightsOf(model, target);
    if (!target.element) {
        all = std::move(values);
        return;
    }
    if (values.size() != 1) base::refuse(fmt::format("expected 1 number a key, found {}", values.size()));
    all[*target.element] = values.front();
}

// Sets a node or a mesh to what a channel says at a time; false if the channel drives something that is not read.
bool apply(tinygltf::Model& model, const tinygltf::Animation& animation, const tinygltf::AnimationChannel& channel,
           double time) {
    const std::optional<AnimationTarget> target = targetOf(channel);
    if (!target) return false;
    if (target->index == -1) return true;
    if (target->ofMesh)
        static_cast<void>(at(model.meshes, target->index, "a mesh"));
    else
        static_cast<void>(at(model.nodes, target->index, "a node"));
    const auto valuesAt = [&](Expected expected, Between between) {
        if (channel.target_path == "pointer" && target->property != Property::Visible) expected.components = anyNumber;
        return Sampler{model, at(animation.samplers, channel.sampler, "a sampler"), expected}.at(time, between);
    };
    const auto index = static_cast<std::size_t>(target->index);
    if (target->property == Property::Visible) {
        const std::vector<double> shown = valuesAt(booleans, Between::Stepped);
        if (shown.size() != 1) base::refuse(fmt::format("expected 1 value a key, found {}", shown.size()));
        setVisible(model.nodes[index], shown.front() != 0.0);
    } else if (target->property == Property::Weights) {
        setWeights(model, *target, valuesAt(weights, Between::Straight));
    } else {
        const Vector& vector = *std::ranges::find(nodeVectors, target->property, &Vector::property);
        const bool turns = target->property == Property::Rotation;
        setVector(model.nodes[index], vector, valuesAt(vector.expected, turns ? Between::Turned : Between::Straight));
    }
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
