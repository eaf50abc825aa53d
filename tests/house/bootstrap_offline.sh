#!/usr/bin/env bash
# Does ./bootstrap say what it needs, and touch nothing where it cannot have it?  Runs it in a made-up machine: a PATH
# of a few links and of stand-ins for Debian's tools.   bootstrap_offline.sh SOURCE WORK
set -euo pipefail
machine=$2
bootstrap=$machine/tree/bootstrap
rm -rf "$machine"
mkdir -p "$machine/tree"
cp "$1/bootstrap" "$bootstrap"
for tool in bash env cat dirname id nproc mkdir mktemp rm tail; do ln -s "$(command -v $tool)" "$machine/$tool"; done

# stand_in NAME LINE...: a tool of the made-up machine.
stand_in() {
  local name=$1
  shift
  printf '%s\n' '#!/usr/bin/env bash' "$@" >"$machine/$name"
  chmod +x "$machine/$name"
}

# expect STATUS WORDS ARGUMENT...: bootstrap ends with the status and says the words.
expect() {
  local status=0 words=$2 wanted=$1 said
  shift 2
  said=$(env -i PATH="$machine" "$bootstrap" "$@" </dev/null 2>&1) || status=$?
  if [ $status -ne "$wanted" ] || [[ $said != *"$words"* ]]; then
    echo "bootstrap $* ended with $status instead of $wanted, or did not say '$words':"
    echo "$said"
    exit 1
  fi
}

expect 0 "Usage:"
expect 0 "Usage:" --help
expect 2 "'tset' is neither" tset

# A machine that is no Debian.
expect 1 "no apt-get" demo
expect 1 "libcli11-dev" demo
expect 1 "g++-aarch64-linux-gnu" arm64
expect 1 "emscripten" browser
expect 1 "libegl-dev" gpu

# A Debian that lacks two packages, without apt-get; then one where apt-get knows no such package.
stand_in dpkg-query 'case "$*" in *libpng-dev | *g++) echo not-installed; exit 1 ;; *) echo installed ;; esac'
expect 1 "  g++ libpng-dev" demo
stand_in apt-get 'echo "apt-get $*" >>'"$machine/asked" \
  'case "$*" in *install*) echo "E: no such package"; exit 100 ;; esac'
stand_in sudo '"$@"'
expect 1 "E: no such package" demo
[ "$(tail -n 1 "$machine/asked")" = \
  "apt-get -o DPkg::Lock::Timeout=300 install -y --no-install-recommends g++ libpng-dev" ]

# Where nothing is missing, apt-get is not asked; cmake is, and what it says on failing is shown.
rm "$machine/asked"
stand_in dpkg-query 'echo installed'
stand_in cmake 'echo "no such preset"; exit 3'
expect 1 "no such preset" demo
[ ! -e "$machine/asked" ]
echo "bootstrap behaves"
