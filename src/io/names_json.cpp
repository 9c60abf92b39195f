#include "io/names_json.h"

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::io {
namespace {

NamedInstance readInstance(const JsonObject& json) {
    NamedInstance instance{json.whole32("id"), json.text("node"), json.text("mesh"), {}, readMatrix(json, "transform")};
    for (const ParsedJson& material : json.list("materials")) {
        if (!material.is_number_unsigned() || material > std::numeric_limits<std::uint32_t>::max())
            refuseValue(json.path("materials"), "whole numbers from 0 to 4294967295", &material);
        instance.materials.push_back(material.get<std::uint32_t>());
    }
    return instance;
}

}  // namespace

Json matrixJson(const glm::dmat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
    return rows;
}

glm::dmat4 readMatrix(const JsonObject& json, std::string_view key) {
    const ParsedJson& rows = json.list(key);
    if (rows.size() != 4) refuseValue(json.path(key), "four rows", &rows);
    glm::dmat4 matrix;
    for (int row = 0; row < 4; ++row) {
        const auto values = vectorOf<glm::dvec4>(rows[static_cast<std::size_t>(row)], json.path(key));
        for (int column = 0; column < 4; ++column) matrix[column][row] = values[column];
    }
    return matrix;
}

Json instancesJson(const SceneNames& names) {
    Json list = Json::array();
    for (const NamedInstance& instance : names.instances) {
        list.push_back({{"id", instance.id},
                        {"node", instance.node},
                        {"mesh", instance.mesh},
                        {"materials", instance.materials},
                        {"transform", matrixJson(instance.transform)}});
    }
    return list;
}

Json materialsJson(const SceneNames& names) {
    Json list = Json::array();
    for (const std::string& name : names.materials) list.push_back({{"id", list.size() + 1}, {"name", name}});
    return list;
}

SceneNames readNames(const JsonObject& json) {
    SceneNames names;
    std::uint32_t last = 0;
    for (const ParsedJson& entry : json.list("instances")) {
        const JsonObject each{&entry, fmt::format("instances[{}]", names.instances.size())};
        names.instances.push_back(readInstance(each));
        const std::uint32_t id = names.instances.back().id;
        if (id <= last)
            refuseValue(each.path("id"), fmt::format("a number over {}, the last one's", last), each.at("id"));
        last = id;
    }
    for (const ParsedJson& entry : json.list("materials")) {
        const JsonObject each{&entry, fmt::format("materials[{}]", names.materials.size())};
        if (each.whole32("id") != names.materials.size() + 1)
            refuseValue(each.path("id"), fmt::format("{}, for they are in order", names.materials.size() + 1),
                        each.at("id"));
        names.materials.push_back(each.text("name"));
    }
    return names;
}

}  // namespace inkedge::io

namespace inkedge {

std::string namesJson(const SceneNames& names) {
    return io::textOf({{"instances", io::instancesJson(names)}, {"materials", io::materialsJson(names)}}, -1);
}

}  // namespace inkedge
