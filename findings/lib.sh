# shellcheck shell=bash
# Sourced by the scripts beside it: a temp folder that goes at exit, and Debian packages that are unpacked into it.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

skip() {
  echo "could not try: $*" >&2
  exit 75
}

# need TOOL...: the tools that the machine itself must have.
need() {
  local tool
  for tool in apt-get dpkg-deb "$@"; do
    command -v "$tool" >/dev/null || skip "no $tool here"
  done
  [[ $(dpkg --print-architecture) == amd64 ]] || skip "the packages are pinned for amd64"
}

# unpack SUITE PACKAGE=VERSION...: packages of that Debian suite, into $work/SUITE. One named without a version is only
# what the others stand on (the C library and the like): the suite's current one serves.
unpack() { fetch_and_unpack download "$@"; }

# unpack_whole SUITE PACKAGE=VERSION...: the same with everything that they depend on, where that is much.
unpack_whole() { fetch_and_unpack 'install --yes --download-only --no-install-recommends' "$@"; }

fetch_and_unpack() {
  local how suite=$2 state=$work/apt-$2 uri package
  read -ra how <<<"$1"
  shift 2
  # The archive is the one that this machine takes its own Debian suite from.
  # shellcheck disable=SC2016  # apt fills these in
  uri=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 ~ /^(bookworm|trixie)$/ { uri = $2 } END { print uri }')
  [[ -n $uri ]] || skip "apt knows no archive of Debian 12 or 13 here"
  local apt=(apt-get -qq -o "Dir::Etc::SourceList=$state/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o "Dir::State=$state" -o Dir::State::status=/dev/null -o "Dir::Cache=$state" -o Acquire::Languages=none
    -o APT::Sandbox::User=root)
  if [[ ! -d $state ]]; then
    mkdir -p "$state/lists/partial" "$state/archives/partial" "$work/$suite"
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $uri $suite main" >"$state/sources.list"
    "${apt[@]}" update --error-on=any >"$state/log" 2>&1 || skip "no package lists of $suite"
  fi
  (cd "$state" && "${apt[@]}" "${how[@]}" "$@" >"$state/log" 2>&1) || skip "not to be had from $suite: $*"
  for package in "$state"/{,archives/}*.deb; do
    [[ -e $package ]] || continue
    [[ ${how[0]} == install ]] || dpkg-deb -W --showformat="$suite: \${Package} \${Version}\n" "$package"
    dpkg-deb -x "$package" "$work/$suite"
    rm "$package"
  done
}

# run SUITE PROGRAM...: with that suite's libraries, on trixie's C and C++ library, which serve older programs as well.
run() {
  local libraries=lib/x86_64-linux-gnu own=$work/$1 ground=$work/trixie/usr
  shift
  "$ground/$libraries/ld-linux-x86-64.so.2" \
    --library-path "$own/usr/$libraries:$own/$libraries:$ground/$libraries" "$@"
}

# run_whole SUITE PROGRAM...: on the C library that came with unpack_whole.
run_whole() {
  local own=$work/$1 folders
  shift
  folders=$(find "$own" -name '*.so.*' -printf '%h\n' | sort -u | paste -sd:)
  "$(find "$own" -name 'ld-linux-x86-64.so.2' ! -path '*/lib64/*' | head -n 1)" --library-path "$folders" "$@"
}

# expect FILE SUITE: the lines that FILE must hold are on standard input. It prints FILE, and fails where they differ.
expect() {
  echo "-- seen with the packages of $2:"
  cat "$1"
  diff -u --label expected --label seen - "$1" >"$work/difference" && return
  echo "no longer as stated:" >&2
  cat "$work/difference" >&2
  exit 1
}
