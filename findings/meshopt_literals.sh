#!/bin/bash
# Version 1 of the vertex codec of KHR_meshopt_compression, by its text, stores elements in groups of 16 and rounds
# their number up, what is over being ignored. One would expect 18 elements to take the room of 32. Where bytes are
# stored as they are (control mode 3) meshoptimizer 1.3.0 writes just as many as there are elements, and refuses data
# that are padded to the group. A decoder written from the text alone goes astray in the last block of many files.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need node npm
cd "$work"
npm install --silent --no-audit --no-fund meshoptimizer@1.3.0 >log 2>&1 || skip "no meshoptimizer 1.3.0 from npm"

# Noise of 4 bytes an element has nothing to pack: all four bytes are of mode 3, a control byte of 0xff. A stream is its
# header byte, the control byte, the data and 24 bytes at the end; padded, the data of 18 elements would be 128 bytes.
cat >sizes.mjs <<'JS'
import {MeshoptDecoder, MeshoptEncoder} from 'meshoptimizer';
await MeshoptEncoder.ready;
await MeshoptDecoder.ready;
let state = 1;
const noise = Uint8Array.from({length: 256}, () => (state = (state * 1103515245 + 12345) % 2147483648) >> 16);
for (const count of [16, 17, 18, 32]) {
  const elements = noise.slice(0, 4 * count);
  const stream = MeshoptEncoder.encodeVertexBufferLevel(elements, count, 4, 3, 1);
  const end = stream.length - 24;
  const padded = new Uint8Array(2 + 64 * Math.ceil(count / 16) + 24);
  padded[0] = stream[0];
  padded[1] = stream[1];
  for (let k = 0; k < 4; ++k)
    padded.set(stream.slice(2 + k * count, 2 + (k + 1) * count), 2 + k * 16 * Math.ceil(count / 16));
  padded.set(stream.slice(end), padded.length - 24);
  const reads = bytes => {
    const decoded = new Uint8Array(4 * count);
    try {
      MeshoptDecoder.decodeVertexBuffer(decoded, count, 4, bytes);
    } catch {
      return 'refused';
    }
    return decoded.every((byte, i) => byte === elements[i]) ? 'read' : 'read as something else';
  };
  const hex = byte => '0x' + byte.toString(16);
  console.log(`${count} elements: header ${hex(stream[0])}, control ${hex(stream[1])}, ${end - 2} bytes of data ` +
              `${reads(stream)}; ${padded.length - 26} bytes ${reads(padded)}`);
}
JS
node sizes.mjs >seen
expect seen "npm, meshoptimizer 1.3.0" <<'SEEN'
16 elements: header 0xa1, control 0xff, 64 bytes of data read; 64 bytes read
17 elements: header 0xa1, control 0xff, 68 bytes of data read; 128 bytes refused
18 elements: header 0xa1, control 0xff, 72 bytes of data read; 128 bytes refused
32 elements: header 0xa1, control 0xff, 128 bytes of data read; 128 bytes read
SEEN
