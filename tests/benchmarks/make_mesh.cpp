// Writes a mesh for benchmarks: make_mesh cad|smooth|scan TRIANGLES FILE.glb
// Prints how many triangles it has.
#include <exception>

#include <fmt/format.h>

#include "meshes.h"

int main(int count, char** arguments) {
    if (count != 4) {
        fmt::print(stderr, "make_mesh: error: expected cad|smooth|scan TRIANGLES FILE.glb, found {} arguments\n",
                   count - 1);
        return 2;
    }
    try {
        const inkedge::Mesh mesh =
            inkedge::benchmarks::makeMesh(inkedge::benchmarks::shapeNamed(arguments[1]), std::stoull(arguments[2]));
        inkedge::benchmarks::writeGlb(mesh, arguments[3]);
        fmt::print("{}\n", mesh.indices.size() / 3);
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_mesh: error: {}\n", error.what());
        return 1;
    }
}
