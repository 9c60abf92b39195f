#include "scene/choose_nodes.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

#include "base/message.h"

namespace inkedge::scene {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

// Whether a text is as a pattern says, in which * stands for any characters and ? for one.
bool matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = std::string_view::npos;  // the last one
    std::size_t covered = 0;                    // up to here the star stands for the text
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            covered = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++covered;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

// A node as patterns see it.
struct Named {
    std::string name;
    std::string path;

    [[nodiscard]] bool is(std::string_view pattern) const { return matches(pattern, name) || matches(pattern, path); }
};

// The nodes with a name that an instance belongs to, from its own up, as namesOf() calls them.
std::vector<Named> nodesOf(const Scene::Data& data, const Instance& instance) {
    std::vector<Named> nodes;
    const auto add = [&](const std::string& name) {
        if (name.empty()) return;
        for (Named& inner : nodes) inner.path.insert(0, name + '/');
        nodes.push_back({name, name});
    };
    add(instance.name);
    if (instance.node >= data.nodes.size()) return nodes;
    for (std::uint32_t i = data.nodes[instance.node].parent; i < data.nodes.size(); i = data.nodes[i].parent)
        add(data.nodes[i].name);
    return nodes;
}

// The patterns of one setting, and which of them some node is named by.
class Patterns {
public:
    explicit Patterns(const std::vector<std::string>& patterns) : patterns_{patterns}, met_(patterns.size(), false) {}

    [[nodiscard]] bool name(const std::vector<Named>& nodes) {
        bool any = false;
        for (std::size_t i = 0; i < patterns_.size(); ++i) {
            const bool one = std::ranges::any_of(nodes, [&](const Named& node) { return node.is(patterns_[i]); });
            met_[i] = met_[i] || one;
            any = any || one;
        }
        return any;
    }

    void warn(std::string_view flag, std::vector<std::string>& warnings) const {
        for (std::size_t i = 0; i < patterns_.size(); ++i) {
            if (!met_[i])
                warnings.push_back(fmt::format("{}: no node is named '{}'", flag, base::printable(patterns_[i])));
        }
    }

private:
    const std::vector<std::string>& patterns_;
    std::vector<bool> met_;
};

[[noreturn]] void refuseAll(const LoadSettings& settings, const std::set<std::string>& names) {
    constexpr std::size_t shown = 8;
    std::vector<std::string> some;
    for (const std::string& name : names) {
        if (some.size() == shown) break;
        some.push_back(base::printable(name));
    }
    if (some.empty()) some.emplace_back("none with a name");
    const std::string more = names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "";
    const std::string found =
        settings.only.empty()
            ? "none left"
            : fmt::format("none for '{}'{}", base::printable(fmt::format("{}", fmt::join(settings.only, ";"))),
                          settings.hide.empty() ? "" : " that --hide leaves");
    throw Error{Error::Kind::Usage,
                fmt::format("--{}: expected a node to draw, found {}; there are {}{}",
                            settings.only.empty() ? "hide" : "only", found, fmt::join(some, ", "), more)};
}

}  // namespace

void dropUnusedMeshes(Scene::Data& data) {
    std::vector<std::uint32_t> renumbered(data.meshes.size(), unused);
    for (const Instance& instance : data.instances) renumbered[instance.mesh] = 0;
    std::vector<Mesh> kept;
    for (std::size_t i = 0; i < data.meshes.size(); ++i) {
        if (renumbered[i] == unused) continue;
        renumbered[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(std::move(data.meshes[i]));
    }
    data.meshes = std::move(kept);
    for (Instance& instance : data.instances) instance.mesh = renumbered[instance.mesh];
}

void chooseNodes(Scene::Data& data, const LoadSettings& settings) {
    if ((settings.only.empty() && settings.hide.empty()) || data.instances.empty()) return;
    Patterns only{settings.only};
    Patterns hide{settings.hide};
    std::set<std::string> names;
    std::erase_if(data.instances, [&](const Instance& instance) {
        const std::vector<Named> nodes = nodesOf(data, instance);
        for (const Named& node : nodes) names.insert(node.name);
        const bool chosen = only.name(nodes);
        const bool hidden = hide.name(nodes);
        return hidden || (!chosen && !settings.only.empty());
    });
    if (data.instances.empty()) refuseAll(settings, names);
    only.warn("--only", data.warnings);
    hide.warn("--hide", data.warnings);
    dropUnusedMeshes(data);
}

}  // namespace inkedge::scene
