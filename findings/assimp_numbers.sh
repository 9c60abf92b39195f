#!/bin/bash
# In a Wavefront OBJ file one would expect .5 to be the number that 0.5 is. assimp 5.2.5 and 5.4.3 take -.5 and +.5, yet
# a vertex line with .5 in it they drop whole, with no error and no warning. The indices after it then mean other
# vertices: the mesh loads, and shows another triangle. Only where an index has no vertex left does the load fail. It
# strikes files whose writer leaves out the 0.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need awk
unpack bookworm assimp-utils=5.2.5~ds0-1+b1 libassimp5=5.2.5~ds0-1+b1 libdraco7=1.5.5+dfsg-2 libminizip1 \
  zlib1g
unpack trixie assimp-utils=5.4.3+ds-2 libassimp5=5.4.3+ds-2 libdraco8 libminizip1t64 libpugixml1v5 \
  zlib1g libstdc++6 libgcc-s1 libc6

# The triangle of vertices 1, 3 and 4, a right angle in the square from 0 to 1; vertex 5 is in no face.
for number in 0.5 +.5 -.5 .5; do
  printf 'v 0 0 0\nv %s 0 0\nv 1 0 0\nv 1 1 0\nv 7 7 7\nf 1 3 4\n' "$number" >"$work/$number.obj"
done

for suite in bookworm trixie; do
  for number in 0.5 +.5 -.5 .5; do
    run "$suite" "$work/$suite/usr/bin/assimp" export "$work/$number.obj" "$work/out.ply" >"$work/log" 2>&1
    echo "$number: $(awk '/^ERROR|^WARN/; seen && NF == 3 { print "(" $0 ")" } /end_header/ { seen = 1 }' \
      "$work/log" "$work/out.ply" | paste -sd ' ')"
  done >"$work/seen"
  expect "$work/seen" "$suite" <<'SEEN'
0.5: (0 0 0) (1 0 0) (1 1 0)
+.5: (0 0 0) (1 0 0) (1 1 0)
-.5: (0 0 0) (1 0 0) (1 1 0)
.5: (0 0 0) (1 1 0) (7 7 7)
SEEN
done
