#!/bin/bash
# A program may hand tinygltf its own file functions, for instance to read from memory. To load, one would expect the
# three that reading needs to do, and with 2.7.0 they do. 2.9.5 adds a fifth function, GetFileSizeInBytes, and refuses
# the whole set unless all five are there, the one that writes files too. The old code still compiles without a warning:
# the refusal is a bool that was void before. Where it goes unread, the load reports success, with a file from the disk.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
unpack bookworm libtinygltf-dev=2.7.0+dfsg-2 nlohmann-json3-dev=3.11.2-2
unpack trixie libtinygltf-dev=2.9.5+dfsg-1 nlohmann-json3-dev=3.11.3-2.1

cat >"$work/load.cpp" <<'CPP'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <cstdio>

static int calls = 0;

static void load(const char* title, const tinygltf::FsCallbacks& files) {
  const std::string json = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 6, "uri": "a.bin"}]})";
  calls = 0;
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(files);
  tinygltf::Model model;
  std::string error, warning;
  const bool loaded = loader.LoadASCIIFromString(&model, &error, &warning, json.data(), json.size(), ".");
  std::printf("%s: loaded %s, own functions called %s", title, loaded ? "yes" : "no", calls > 0 ? "yes" : "no");
  if (loaded) std::printf(", buffer \"%.6s\"", reinterpret_cast<const char*>(model.buffers[0].data.data()));
  std::printf(", error \"%s\", warning \"%s\"\n", error.c_str(), warning.c_str());
}

int main() {
  tinygltf::FsCallbacks files{};
  files.FileExists = [](const std::string&, void*) { return ++calls > 0; };
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string&, void*) {
    out->assign({'m', 'e', 'm', 'o', 'r', 'y'});
    return true;
  };
  load("three to read", files);
  files.WriteWholeFile = [](auto*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
  load("and one to write", files);
#ifdef WITH_SIZE
  files.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string&, void*) { return *size = 6, true; };
  load("and one for sizes", files);
  files.WriteWholeFile = nullptr;
  load("all but the one to write", files);
#endif
}
CPP
cd "$work"
printf disk:: >a.bin
g++ -Wall -Wextra -Werror -isystem bookworm/usr/include load.cpp -o load
./load >seen
expect seen bookworm <<'SEEN'
three to read: loaded yes, own functions called yes, buffer "memory", error "", warning ""
and one to write: loaded yes, own functions called yes, buffer "memory", error "", warning ""
SEEN
g++ -DWITH_SIZE -Wall -Wextra -Werror -isystem trixie/usr/include load.cpp -o load
./load >seen
expect seen trixie <<'SEEN'
three to read: loaded yes, own functions called no, buffer "disk::", error "", warning ""
and one to write: loaded yes, own functions called no, buffer "disk::", error "", warning ""
and one for sizes: loaded yes, own functions called yes, buffer "memory", error "", warning ""
all but the one to write: loaded yes, own functions called no, buffer "disk::", error "", warning ""
SEEN
