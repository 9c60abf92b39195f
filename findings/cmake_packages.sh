#!/bin/bash
# find_package would be expected to succeed once a library's -dev package and what it depends on are there. Debian's
# libosd-dev (OpenSubdiv 3.5.0, 3.6.0) it refuses: the package's CMake files ask for a static library that neither it
# nor its dependencies bring. libopenimageio-dev (2.4.7.1, 2.5.18.0) is found next to openimageio-tools only, on which
# it does not depend, and then gives its users OpenCV's include folder, which is no dependency's either: where OpenCV's
# headers are not installed, CMake refuses to build with it. So a project must find both by hand, or mend their targets.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need cmake make g++
unpack bookworm libosd-dev=3.5.0-2 libosdcpu3.5.0=3.5.0-2 libosdgpu3.5.0=3.5.0-2 \
  libopenimageio-dev=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2 libimath-dev libimath-3-1-29
unpack trixie libosd-dev=3.6.0-3 libosdcpu3.6.0=3.6.0-3 libosdgpu3.6.0=3.6.0-3 \
  libopenimageio-dev=2.5.18.0+dfsg-1+b1 libopenimageio2.5=2.5.18.0+dfsg-1+b1 libimath-dev libimath-3-1-29t64

mkdir "$work/project"
cat >"$work/project/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.20)
project(try CXX)
find_package(${package} CONFIG REQUIRED)
get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
message(STATUS "found, with the include folders ${folders}")
CMAKE

# look SUITE PACKAGE TARGET: the file that CMake misses, or the include folders that the target gives its users.
look() {
  local root=$work/$1/usr
  cmake -S "$work/project" -B "$work/build-$1-$2" -Dpackage="$2" -Dtarget="$3" -DCMAKE_PREFIX_PATH="$root" \
    "-D$2_DIR=$root/lib/x86_64-linux-gnu/cmake/$2" >"$work/log" 2>&1 || true
  echo "$1 $2: $(sed "s|$work/$1||g" "$work/log" |
    awk '/^CMake Error/ { wrong = 1 } wrong && /^ *"\// { print "misses", $1; exit } sub(/^-- found/, "found")')"
}

for suite in bookworm trixie; do
  look "$suite" OpenSubdiv OpenSubdiv::osdCPU
  look "$suite" OpenImageIO OpenImageIO::OpenImageIO
done >"$work/seen"
expect "$work/seen" "both suites" <<'SEEN'
bookworm OpenSubdiv: misses "/usr/lib/x86_64-linux-gnu/libosdCPU.a"
bookworm OpenImageIO: misses "/usr/bin/iconvert"
trixie OpenSubdiv: misses "/usr/lib/x86_64-linux-gnu/libosdCPU.a"
trixie OpenImageIO: misses "/usr/bin/iconvert"
SEEN

unpack bookworm openimageio-tools=2.4.7.1+dfsg-2
unpack trixie openimageio-tools=2.5.18.0+dfsg-1+b1
for suite in bookworm trixie; do
  look "$suite" OpenImageIO OpenImageIO::OpenImageIO
done >"$work/seen"
expect "$work/seen" "both suites" <<'SEEN'
bookworm OpenImageIO: found, with the include folders /usr/include;/usr/include;/usr/include/opencv4
trixie OpenImageIO: found, with the include folders /usr/include;/usr/include;/usr/include/opencv4
SEEN
