#!/bin/bash
# A C function gives vector registers back as the calling convention asks (System V ABI for x86-64, 3.2.1: vzeroupper
# before it returns, where it used their upper halves). ISA-L's isal_deflate and crc32_gzip_refl, 2.30.0 and 2.31.1, do
# not: afterwards the processor keeps the upper halves as in use, and code compiled for plain x86-64 runs slower in the
# same thread until somebody clears them: a loop of float to double to byte takes four times as long on an EPYC of 2024.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "$0")/lib.sh"
need g++
grep -qw avx2 /proc/cpuinfo || skip "the processor has no AVX2"
unpack bookworm libisal2=2.30.0-5 libisal-dev=2.30.0-5
unpack trixie libisal2=2.31.1-1.1 libisal-dev=2.31.1-1.1 libc6 libstdc++6 libgcc-s1

cat >"$work/halves.cpp" <<'CPP'
#include <cpuid.h>
#include <immintrin.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

// Bit 2 of the state that is in use (Intel SDM 1, 13.6).
bool inUse() {
  unsigned low, high;
  asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(1));
  return (low & 4) != 0;
}
__attribute__((target("avx"), noinline)) void clear() { _mm256_zeroupper(); }

double milliseconds() {
  static std::vector<float> from(1 << 20, 0.3F);
  static std::vector<unsigned char> to(from.size());
  double least = 1e9;
  for (int run = 0; run < 20; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double share = (from[i] + 1.0) / 2.0;
      to[i] = static_cast<unsigned char>(share > 0.0 ? 255.0 * std::min(share, 1.0) + 0.5 : 0.0);
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count());
  }
  return least;
}

void report(const char* after) {
  const bool used = inUse();
  std::fprintf(stderr, "%s: a loop takes %.2f ms\n", after, milliseconds());
  std::printf("%s: upper halves %s\n", after, used ? "in use" : "clear");
  clear();
}

int main() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (!__get_cpuid_count(0xD, 1, &a, &b, &c, &d) || !(a & 4)) return 75;
  clear();
  report("at first");
  std::vector<unsigned char> in(1 << 16), out(1 << 18), work(ISAL_DEF_LVL1_LARGE);
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = static_cast<unsigned char>(i * i >> 7);
  static isal_zstream stream;
  isal_deflate_init(&stream);
  stream.level = 1;
  stream.level_buf = work.data();
  stream.level_buf_size = static_cast<unsigned>(work.size());
  stream.end_of_stream = 1;
  stream.next_in = in.data();
  stream.avail_in = static_cast<unsigned>(in.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<unsigned>(out.size());
  if (isal_deflate(&stream) != COMP_OK) return 1;
  report("after isal_deflate");
  static_cast<void>(crc32_gzip_refl(0, in.data(), in.size()));
  report("after crc32_gzip_refl");
}
CPP
for suite in bookworm trixie; do
  root=$work/$suite/usr
  g++ -O2 -I "$root/include" "$work/halves.cpp" -o "$work/halves-$suite" "$root/lib/x86_64-linux-gnu/libisal.so.2"
  run "$suite" "$work/halves-$suite" >"$work/seen" || skip "the processor does not say what is in use"
  expect "$work/seen" "$suite" <<'END'
at first: upper halves clear
after isal_deflate: upper halves in use
after crc32_gzip_refl: upper halves in use
END
done
