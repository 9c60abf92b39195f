#!/bin/bash
# What glTF 2.0 lets a file leave out, one would expect a reader to do without. An animation channel's target may have
# no node (it is for an extension to say what it drives), and an accessor no bufferView (it is zeros, or all of it
# sparse). tinygltf 2.7.0 loads positions of such an accessor, and refuses the whole file where it holds indices. For
# such a channel it returns success and an error text at once, and the animation lacks the channel. tinygltf 2.9.5 takes
# all of them.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libtinygltf-dev=2.7.0+dfsg-2 nlohmann-json3-dev=3.11.2-2
unpack trixie libtinygltf-dev=2.9.5+dfsg-1 nlohmann-json3-dev=3.11.3-2.1

# A triangle, indices 0 1 2, and an animation that holds its node in one place. The buffer: positions at 0, indices at
# 36, the sparse values' own numbers 0 1 2 at 44, a time at 52 and a translation at 56.
zero='\x00\x00\x00\x00' one='\x00\x00\x80\x3f'
data=$({
  printf '%b' "$zero$zero$zero$one$zero$zero$zero$one$zero"
  printf '%b' '\x00\x00\x01\x00\x02\x00\x00\x00\x00\x00\x01\x00\x02\x00\x00\x00'
  printf '%b' "$zero$zero$zero$zero"
} | base64 -w0)
# model NAME TARGET POSITIONS INDICES
model() {
  cat >"$work/$1.gltf" <<JSON
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "animations": [{"samplers": [{"input": 2, "output": 3}],
                 "channels": [{"sampler": 0, "target": {$2"path": "translation"}}]}],
 "accessors": [{$3, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
               {$4, "componentType": 5123, "count": 3, "type": "SCALAR"},
               {"bufferView": 2, "componentType": 5126, "count": 1, "type": "SCALAR", "min": [0], "max": [0]},
               {"bufferView": 3, "componentType": 5126, "count": 1, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6},
                 {"buffer": 0, "byteOffset": 52, "byteLength": 4}, {"buffer": 0, "byteOffset": 56, "byteLength": 12},
                 {"buffer": 0, "byteOffset": 44, "byteLength": 6}],
 "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64,$data"}]}
JSON
}
sparse() {
  echo '"sparse": {"count": 3, "indices": {"bufferView": 4, "componentType": 5123},' "\"values\": {\"bufferView\": $1}}"
}
node='"node": 0, '
model plain "$node" '"bufferView": 0' '"bufferView": 1'
model channel-without-node '' '"bufferView": 0' '"bufferView": 1'
model sparse-positions "$node" "$(sparse 0)" '"bufferView": 1'
model sparse-indices "$node" '"bufferView": 0' "$(sparse 1)"

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
    const std::size_t channels = model.animations.empty() ? 0 : model.animations[0].channels.size();
    std::printf("%s: %s, %zu channels; error \"%s\"\n", std::strrchr(*name, '/') + 1, loaded ? "loaded" : "refused",
                channels, error.substr(0, error.find('\n')).c_str());
  }
}
CPP
files=("$work"/{plain,channel-without-node,sparse-positions,sparse-indices}.gltf)
seen() {
  g++ -isystem "$work/$1/usr/include" "$work/read.cpp" -o "$work/read"
  "$work/read" "${files[@]}" >"$work/seen"
}
seen bookworm
expect "$work/seen" bookworm <<'SEEN'
plain.gltf: loaded, 1 channels; error ""
channel-without-node.gltf: loaded, 0 channels; error "'node' property is missing."
sparse-positions.gltf: loaded, 1 channels; error ""
sparse-indices.gltf: refused, 0 channels; error "accessor[1] invalid bufferView"
SEEN
seen trixie
expect "$work/seen" trixie <<'SEEN'
plain.gltf: loaded, 1 channels; error ""
channel-without-node.gltf: loaded, 1 channels; error ""
sparse-positions.gltf: loaded, 1 channels; error ""
sparse-indices.gltf: loaded, 1 channels; error ""
SEEN
