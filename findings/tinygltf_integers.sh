#!/bin/bash
# glTF 2.0 (JSON Encoding) lets a whole number be written 36, 36.0 or 3.6e1, so one would expect these to be read alike.
# tinygltf 2.7.0 and 2.9.5 take only 36. An optional property written otherwise counts as absent, with no error and no
# warning: the node loses its mesh, the primitive its indices, the accessor its offset. Only a required one, such as an
# accessor's count, fails. A writer that holds every JSON number as a double may write such files.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libtinygltf-dev=2.7.0+dfsg-2 nlohmann-json3-dev=3.11.2-2
unpack trixie libtinygltf-dev=2.9.5+dfsg-1 nlohmann-json3-dev=3.11.3-2.1

# Two triangles, at z = 0 and at z = 2, and the indices 0 2 1. The file shows the second triangle by these indices.
zero='\x00\x00\x00\x00' one='\x00\x00\x80\x3f' two='\x00\x00\x00\x40'
data=$({
  printf '%b' "$zero$zero$zero$one$zero$zero$zero$one$zero"
  printf '%b' "$zero$zero$two$one$zero$two$zero$one$two"
  printf '%b' '\x00\x00\x02\x00\x01\x00'
} | base64 -w0)
cat >"$work/plain.gltf" <<JSON
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [{"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 2], "max": [1, 1, 2]},
               {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 6}],
 "buffers": [{"byteLength": 78, "uri": "data:application/octet-stream;base64,$data"}]}
JSON
sed 's/"indices": 1/"indices": 1.0/' "$work/plain.gltf" >"$work/indices-1.0.gltf"
sed 's/"byteOffset": 36/"byteOffset": 36.0/' "$work/plain.gltf" >"$work/offset-36.0.gltf"
sed 's/"byteOffset": 36/"byteOffset": 3.6e1/' "$work/plain.gltf" >"$work/offset-3.6e1.gltf"
sed 's/"mesh": 0/"mesh": 0.0/' "$work/plain.gltf" >"$work/mesh-0.0.gltf"
sed 's/"count": 3/"count": 3.0/' "$work/plain.gltf" >"$work/count-3.0.gltf"

cat >"$work/read.cpp" <<'CPP'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <cstdio>
#include <cstring>

int main(int, char** arguments) {
  for (char** name = arguments + 1; *name != nullptr; ++name) {
    tinygltf::Model model;
    std::string error, warning;
    const bool loaded = tinygltf::TinyGLTF().LoadASCIIFromFile(&model, &error, &warning, *name);
    std::printf("%s: ", std::strrchr(*name, '/') + 1);
    if (loaded) {
      const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
      const std::size_t at = model.accessors[primitive.attributes.at("POSITION")].byteOffset;
      float point[3];
      std::memcpy(point, model.buffers[0].data.data() + at, sizeof point);
      std::printf("node's mesh %d, z %g, %s; ", model.nodes[0].mesh, point[2],
                  primitive.indices < 0 ? "no indices" : "indices");
    }
    std::printf("error \"%s\", warning \"%s\"\n", error.substr(0, error.find('\n')).c_str(), warning.c_str());
  }
}
CPP
files=("$work"/{plain,indices-1.0,offset-36.0,offset-3.6e1,mesh-0.0,count-3.0}.gltf)
for suite in bookworm trixie; do
  g++ -isystem "$work/$suite/usr/include" "$work/read.cpp" -o "$work/read"
  "$work/read" "${files[@]}" >"$work/seen"
  expect "$work/seen" "$suite" <<'SEEN'
plain.gltf: node's mesh 0, z 2, indices; error "", warning ""
indices-1.0.gltf: node's mesh 0, z 2, no indices; error "", warning ""
offset-36.0.gltf: node's mesh 0, z 0, indices; error "", warning ""
offset-3.6e1.gltf: node's mesh 0, z 0, indices; error "", warning ""
mesh-0.0.gltf: node's mesh -1, z 2, indices; error "", warning ""
count-3.0.gltf: error "'count' property is not a positive integer.", warning ""
SEEN
done
