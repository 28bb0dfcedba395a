#!/usr/bin/env bash
# installed_test.sh CMAKE BUILD EXAMPLE: installs BUILD aside, builds EXAMPLE against it and runs it.
set -euo pipefail
cmake=$1 build=$2 example=$3
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

"$cmake" --install "$build" --prefix "$dir/usr" >/dev/null
"$dir/usr/bin/plumb" --version >/dev/null
"$cmake" -S "$example" -B "$dir/example" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$dir/usr" >/dev/null
"$cmake" --build "$dir/example" >/dev/null
"$dir/example/use_plumb"
