#!/bin/bash
# In PDF a stroke is drawn where it lies unless the graphics state asks for automatic stroke adjustment, which it does
# not by default (ISO 32000-1, table 57: SA). poppler 22.12 adjusts all the same: an upright stroke a pixel wide, 0.3
# pixels off the grid, covers one column of pixels in full, and so does a rectangle that is filled. The same stroke at a
# slant stays where it is. Upright and level lines of a technical drawing so stand up to half a pixel off the slanted
# ones that they meet, and a comparison of pictures finds them moved; at four times the resolution, averaged down, they
# are not.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need od awk
unpack bookworm poppler-utils=22.12.0-2+deb12u2 libpoppler126=22.12.0-2+deb12u2 libbrotli1 libdeflate0 libfontconfig1 \
  libfreetype6 libjbig0 libjpeg62-turbo liblcms2-2 liblerc4 libnspr4 libnss3 libopenjp2-7 libpng16-16 libtiff6 \
  libwebp7 libzstd1 libexpat1 zlib1g liblzma5
unpack trixie libstdc++6 libgcc-s1 libc6

# A page of 16 x 8 points that holds this alone.
page() {
  local name=$1 content=$2 at offsets=() object n=0
  local file=$work/$name.pdf
  printf '%%PDF-1.4\n' >"$file"
  for object in '<< /Type /Catalog /Pages 2 0 R >>' '<< /Type /Pages /Kids [3 0 R] /Count 1 >>' \
    '<< /Type /Page /Parent 2 0 R /MediaBox [0 0 16 8] /Contents 4 0 R /Resources << >> >>' \
    "<< /Length ${#content} >> stream
$content
endstream"; do
    offsets+=("$(stat --format %s "$file")")
    printf '%d 0 obj\n%s\nendobj\n' "$((++n))" "$object" >>"$file"
  done
  at=$(stat --format %s "$file")
  {
    printf 'xref\n0 5\n0000000000 65535 f \n'
    printf '%010d 00000 n \n' "${offsets[@]}"
    printf 'trailer << /Size 5 /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n' "$at"
  } >>"$file"
}
page stroke '1 w 8.3 0 m 8.3 8 l S'
page filled '7.8 0 1 8 re f'
page slanted '1 w 7.3 0 m 9.3 8 l S'

# Columns 6 to 10 of row 4, of 8: 255 is paper.
for name in stroke filled slanted; do
  run bookworm "$work/bookworm/usr/bin/pdftoppm" -gray -r 72 -singlefile "$work/$name.pdf" "$work/$name" 2>"$work/log"
  echo "$name: $(tail -c 128 "$work/$name.pgm" | od -An -v -tu1 -w16 | awk 'NR == 5 { print $7, $8, $9, $10, $11 }')"
done >"$work/seen"
run bookworm "$work/bookworm/usr/bin/pdftoppm" -gray -r 288 -singlefile "$work/stroke.pdf" "$work/fine" 2>"$work/log"
# Of 64 columns and 32 rows, those that stand for the same pixels.
fine=$(tail -c 2048 "$work/fine.pgm" | od -An -v -tu1 -w64 |
  awk 'NR > 16 && NR <= 20 { for (c = 0; c < 20; ++c) sum[int(c / 4)] += $(25 + c) }
    END { for (i = 0; i < 5; ++i) printf "%s%d", i ? " " : "", sum[i] / 16 }')
echo "stroke, four times as fine: $fine" >>"$work/seen"
expect "$work/seen" bookworm <<'SEEN'
stroke: 255 255 0 255 255
filled: 255 255 0 255 255
slanted: 255 165 46 255 255
stroke, four times as fine: 255 191 63 255 255
SEEN
