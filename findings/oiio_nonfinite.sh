#!/bin/bash
# Of two pictures that differ where one has NaN or infinity, as depth maps have beyond the last surface, OpenImageIO's
# idiff would be expected to say that they differ. 2.4.7 and 2.5.18 say PASS and exit with 0, whatever the other picture
# has there: NaN is over no threshold, and a difference that is not finite is left out of the largest one. A test of
# depth maps must compare what is not finite by itself.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need python3
unpack_whole bookworm openimageio-tools=2.4.7.1+dfsg-2
unpack_whole trixie openimageio-tools=2.5.18.0+dfsg-1+b1

python3 - "$work" <<'PY'
import struct
import sys

# Portable float maps: 4 x 4 grey pixels, of which one differs.
for name, value in {"same": 0.5, "other": 0.75, "nan": float("nan"), "infinite": float("inf")}.items():
    pixels = [0.5] * 16
    pixels[5] = value
    with open(f"{sys.argv[1]}/{name}.pfm", "wb") as file:
        file.write(b"Pf\n4 4\n-1.0\n" + struct.pack("<16f", *pixels))
PY

for suite in bookworm trixie; do
  for pair in 'same same' 'same other' 'same nan' 'same infinite' 'nan infinite'; do
    read -r one two <<<"$pair"
    status=0
    run_whole "$suite" "$work/$suite/usr/bin/idiff" "$work/$one.pfm" "$work/$two.pfm" >"$work/log" 2>&1 || status=$?
    echo "$one, $two: $(tail -n 1 "$work/log"), exit status $status"
  done >"$work/seen"
  expect "$work/seen" "$suite" <<'END'
same, same: PASS, exit status 0
same, other: FAILURE, exit status 2
same, nan: PASS, exit status 0
same, infinite: PASS, exit status 0
nan, infinite: PASS, exit status 0
END
done
