# shellcheck shell=bash
# Sourced by the scripts beside it: a temp folder that goes at exit, and Debian packages unpacked into it, never installed.
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

# unpack SUITE PACKAGE=VERSION...: packages of that Debian suite, into $work/SUITE. A package named without a version is
# only the ground to run on (the C library and the like): the suite's own serves.
unpack() {
  local suite=$1 state=$work/apt-$1 uri package
  shift
  # The archive is the one that this machine takes its own Debian suite from.
  # shellcheck disable=SC2016  # apt fills these in
  uri=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 ~ /^(bookworm|trixie|forky|sid|stable|testing)$/ { print $2; exit }')
  [[ -n $uri ]] || skip "apt knows no Debian archive here"
  local apt=(apt-get -qq -o "Dir::Etc::SourceList=$state/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o "Dir::State=$state" -o Dir::State::status=/dev/null -o "Dir::Cache=$state" -o Acquire::Languages=none
    -o APT::Sandbox::User=root)
  if [[ ! -d $state ]]; then
    mkdir -p "$state/lists/partial" "$state/archives/partial" "$work/$suite"
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $uri $suite main" >"$state/sources.list"
    "${apt[@]}" update --error-on=any >"$state/log" 2>&1 || skip "no package lists of $suite"
  fi
  (cd "$state" && "${apt[@]}" download "$@" >"$state/log" 2>&1) || skip "not to be had from $suite: $*"
  for package in "$state"/*.deb; do
    dpkg-deb -W --showformat="$suite: \${Package} \${Version}\n" "$package"
    dpkg-deb -x "$package" "$work/$suite"
    rm "$package"
  done
}

# run SUITE PROGRAM...: with that suite's libraries, its C library among them.
run() {
  local root=$work/$1 loader
  loader=$(find "$root" -path '*/x86_64-linux-gnu/ld-linux-x86-64.so.2' -print -quit)
  shift
  "$loader" --library-path "$root/lib/x86_64-linux-gnu:$root/usr/lib/x86_64-linux-gnu" "$@"
}

# expect FILE: the lines that FILE must hold are on standard input. It prints FILE, and fails where they differ.
expect() {
  cat "$1"
  diff -u --label expected --label seen - "$1" >"$work/difference" && return
  echo "no longer as stated:" >&2
  cat "$work/difference" >&2
  exit 1
}
