#pragma once

#include <sys/resource.h>

#include "cli/command.h"

namespace faults {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool addressSpaceCanBeLimited = false;
#else
inline constexpr bool addressSpaceCanBeLimited = true;
#endif

class Faults : public Command {
protected:
    using Prepare = std::function<void()>;

    Outcome runWith(const Prepare& prepare, const Arguments& arguments) const {
        return Running{INKEDGE_COMMAND, arguments, folder_.path(), {}, prepare}.finish();
    }

    void expectNothingLeft() const {
        EXPECT_THAT(folder_.names(), testing::IsEmpty()) << "a failure must leave nothing behind";
    }

    /// A wavy sheet of 2 x side x side triangles.
    std::string bigModel(std::uint32_t side) const {
        std::string vertices;
        std::string indices;
        const auto append = [](std::string& bytes, const auto& values) {
            bytes.append(reinterpret_cast<const char*>(values.data()), sizeof values);
        };
        for (std::uint32_t j = 0; j <= side; ++j) {
            for (std::uint32_t i = 0; i <= side; ++i) {
                const auto x = static_cast<float>(i) / static_cast<float>(side);
                const auto z = static_cast<float>(j) / static_cast<float>(side);
                append(vertices, std::array{x, 0.1F * std::sin(20.0F * x) * std::cos(17.0F * z), z});
                if (i == side || j == side) continue;
                const std::uint32_t a = j * (side + 1) + i;
                append(indices, std::array{a, a + side + 1, a + 1, a + 1, a + side + 1, a + side + 2});
            }
        }
        put(models_ / "big.bin", vertices + indices);
        using nlohmann::json;
        const json model{
            {"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
            {"buffers", {{{"uri", "big.bin"}, {"byteLength", vertices.size() + indices.size()}}}},
            {"bufferViews",
             {{{"buffer", 0}, {"byteLength", vertices.size()}},
              {{"buffer", 0}, {"byteOffset", vertices.size()}, {"byteLength", indices.size()}}}},
            {"accessors",
             {{{"bufferView", 0},
               {"componentType", 5126},
               {"type", "VEC3"},
               {"count", vertices.size() / 12},
               {"min", {0.0, -0.1, 0.0}},
               {"max", {1.0, 0.1, 1.0}}},
              {{"bufferView", 1}, {"componentType", 5125}, {"type", "SCALAR"}, {"count", indices.size() / 4}}}}};
        return file("big.gltf", model.dump());
    }
};

inline void giveDevice(int stream, const char* device) { ::dup2(::open(device, O_WRONLY | O_CLOEXEC), stream); }

inline void limit(__rlimit_resource resource, rlim_t bytes) {
    const rlimit limits{bytes, bytes};
    ::setrlimit(resource, &limits);
}

}  // namespace faults
