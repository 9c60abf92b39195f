#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <inkedge/settings.h>

#include "base/temporary_folder.h"
#include "cli/run_command.h"

/// "depth,normal,...", as --maps takes it.
inline std::string everyMap() {
    std::string names;
    for (int i = 0; i < inkedge::mapCount; ++i) {
        names += (i == 0 ? "" : ",") + std::string{inkedge::name(static_cast<inkedge::Map>(i))};
    }
    return names;
}

/// Runs the built command in an empty folder, with small models of its own in another one.
class Command : public testing::Test {
protected:
    static std::string asset(const std::string& name) { return INKEDGE_SOURCE_DIR "/assets/" + name; }

    /// Two faces that meet at 40 degrees in a ridge along z, welded, without normals; one camera.
    std::string roof() const {
        const float ridge = std::tan(20.0F * 3.14159265F / 180.0F);
        return writeModel("roof", {0, ridge, 1, 0, ridge, -1, 1, 0, 1, 1, 0, -1, -1, 0, 1, -1, 0, -1},
                          {0, 2, 3, 0, 3, 1, 4, 0, 1, 4, 1, 5});
    }

    std::string roofWithoutNumber() const {
        return writeModel("not_a_number", {0, 0, 0, 1, 0, 0, std::numeric_limits<float>::quiet_NaN(), 1, 0}, {0, 1, 2});
    }

    std::string emptyModel() const {
        const std::filesystem::path file = models_ / "empty.gltf";
        put(file, R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": []}], "scene": 0})");
        return file;
    }

    /// A file that is no model, or a broken one.
    std::string file(const std::string& name, const std::string& content) const {
        put(models_ / name, content);
        return models_ / name;
    }

    Outcome run(const Arguments& arguments, const Environment& environment = {}) const {
        return runCommand(INKEDGE_COMMAND, arguments, folder_.path(), environment);
    }

    /// inkedge render MODEL -o picture.png --metadata metadata.json with the classic detector, 48 x 48, and these.
    Outcome render(const std::string& model, const Arguments& more = {}, const Environment& environment = {}) const {
        Arguments arguments{"render", model, "-o", "picture.png", "--metadata", "metadata.json"};
        for (const auto& [flag, value] : {std::pair{"--size", "48x48"}, std::pair{"--detector", "classic"}}) {
            const auto given = [start = flag](const std::string& argument) { return argument.starts_with(start); };
            if (std::ranges::none_of(more, given)) arguments.insert(arguments.end(), {flag, value});
        }
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments, environment);
    }

    nlohmann::json metadata() const { return nlohmann::json::parse(contents(folder_ / "metadata.json")); }

    /// Variables with which no OpenGL context can be made: no EGL vendor, and a Mesa that is too old.
    static Environment withoutBackends() {
        return {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}, {"MESA_GL_VERSION_OVERRIDE", "3.3"}};
    }

    bool works(const std::string& backend) const {
        const auto doctor = nlohmann::json::parse(run({"doctor", "--json"}).out);
        return std::ranges::any_of(doctor["backends"],
                                   [&](const auto& each) { return each["backend"] == backend && each["works"]; });
    }

    TemporaryFolder folder_;
    TemporaryFolder models_;

private:
    std::string writeModel(const std::string& name, const std::vector<float>& positions,
                           const std::vector<std::uint16_t>& indices) const {
        using nlohmann::json;
        const std::size_t positionBytes = positions.size() * sizeof(float);
        const std::size_t indexBytes = indices.size() * sizeof(std::uint16_t);
        std::string bytes(positionBytes + indexBytes, '\0');
        std::memcpy(bytes.data(), positions.data(), positionBytes);
        std::memcpy(bytes.data() + positionBytes, indices.data(), indexBytes);
        put(models_ / (name + ".bin"), bytes);

        const json model{
            {"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0, 1}}}}},
            {"nodes", {{{"mesh", 0}}, {{"camera", 0}, {"translation", {0.0, 0.2, 5.0}}}}},
            {"cameras", {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}}},
            {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
            {"buffers", {{{"uri", name + ".bin"}, {"byteLength", bytes.size()}}}},
            {"bufferViews",
             {{{"buffer", 0}, {"byteLength", positionBytes}},
              {{"buffer", 0}, {"byteOffset", positionBytes}, {"byteLength", indexBytes}}}},
            {"accessors",
             {{{"bufferView", 0},
               {"componentType", 5126},
               {"type", "VEC3"},
               {"count", positions.size() / 3},
               {"min", {-1, 0, -1}},
               {"max", {1, 1, 1}}},
              {{"bufferView", 1}, {"componentType", 5123}, {"type", "SCALAR"}, {"count", indices.size()}}}}};
        const std::filesystem::path file = models_ / (name + ".gltf");
        put(file, model.dump());
        return file;
    }
};

/// An error is one line on stderr; stdout stays empty.
inline void expectError(const Outcome& outcome, int exitCode, const testing::Matcher<const std::string&>& text) {
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.error, testing::StartsWith("inkedge: error: "));
    EXPECT_EQ(outcome.error.find('\n'), outcome.error.size() - 1) << "expected one line, found " << outcome.error;
    EXPECT_THAT(outcome.error, text);
}

/// An error that says what was expected and what was found.
inline void expectFailure(const Outcome& outcome, int exitCode, const testing::Matcher<const std::string&>& text) {
    expectError(outcome, exitCode, text);
    EXPECT_THAT(outcome.error, testing::AllOf(testing::HasSubstr("expected "), testing::HasSubstr(", found")));
}

inline void expectSuccess(const Outcome& outcome) { EXPECT_EQ(outcome.exitCode, 0) << outcome.error; }
