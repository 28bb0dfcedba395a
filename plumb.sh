#!/usr/bin/env bash
# plumb.sh: installs what is missing, builds, and runs plumb. One script from a bare Debian 12.
#
#   ./plumb.sh demo             constants refitted to the maps in data/heightmaps, and the report
#                               of a scene
#   ./plumb.sh test [PRESET]    every test (PRESET: release, debug or sanitize)
#   ./plumb.sh SUBCOMMAND ...   any subcommand of plumb: fit, report, truth ...; --help teaches
#   ./plumb.sh build [PRESET]   only build
#   ./plumb.sh packages         only install what is missing
#
# A second call with nothing changed starts at once. PLUMB_JOBS=N builds with N processes.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
jobs=${PLUMB_JOBS:-$(nproc)}

packages=(
  cmake g++ ninja-build
  libeigen3-dev libtbb-dev libceres-dev libembree-dev libhwy-dev libassimp-dev
  libopenimageio-dev openimageio-tools libtiff-dev libssl-dev
  libcli11-dev nlohmann-json3-dev libjs-chart.js
  libgtest-dev libgmock-dev glslang-tools
)

say() { printf 'plumb.sh: %s\n' "$*" >&2; }

# Asks dpkg what is missing, and apt only if something is.
install_missing() {
  local missing=() package
  for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)" = installed ] ||
      missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${missing[*]}"
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "need root or sudo to install packages"; exit 3; }
    root=(sudo)
  fi
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# Configures once; ninja itself notices when a CMakeLists.txt has changed.
build() {
  local preset=$1 target=$2
  install_missing
  cd "$here"
  if [ ! -f "build/$preset/build.ninja" ]; then
    say "configuring ($preset)"
    cmake --preset "$preset" >/dev/null
  fi
  if ! ninja -C "build/$preset" -n "$target" | grep -q 'no work to do'; then
    say "building ($preset)"
    ninja -C "build/$preset" -j "$jobs" --quiet "$target" >&2
  fi
}

demo() {
  build release plumb
  cd "$here"
  build/release/app/plumb fit data/heightmaps/{stone_wall,bricks,cobbles,jacksboro,finland}.png \
    make:gravel:128 make:hex_tiles:128 make:shapes:128 make:terrain:128 \
    --slices 16 --starts 4 --bootstrap 20 --out out/demo
  build/release/app/plumb report atrium --spp 128 --rounds 5 --out out/demo/atrium
  say "open out/demo/report.html and out/demo/atrium/report.html in a browser"
}

tests() {
  local preset=${1:-release}
  build "$preset" all
  cd "$here"
  ninja -C "build/$preset" -j "$jobs" --quiet all_verify_interface_header_sets >&2
  ctest --preset "$preset"
}

case "${1:-help}" in
  demo) demo ;;
  test) tests "${2:-release}" ;;
  build) build "${2:-release}" all ;;
  packages) install_missing ;;
  help | -h | --help) sed -n '2,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" ;;
  *)
    from=$PWD
    build release plumb
    cd "$from"
    exec "$here/build/release/app/plumb" "$@"
    ;;
esac
