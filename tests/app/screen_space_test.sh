#!/usr/bin/env bash
# plumb render and plumb report as a user meets them: what is refused, what a small run leaves.
# Usage: screen_space_test.sh PLUMB
set -u
plumb=$1
. "$(dirname "$0")/expect.sh"

small=(--width 64 --height 36)
for command in render report; do
  refused 'missing.json' "$plumb" $command missing.json
  refused 'nothing_such' "$plumb" $command make:nothing_such
  refused '--radius = 0, must be in (0, infinity)' "$plumb" $command wedge "${small[@]}" --radius 0
  refused '--radius = -1, must be in' "$plumb" $command wedge "${small[@]}" --radius -1
  refused '--radius = nan, must be in' "$plumb" $command wedge "${small[@]}" --radius nan
  refused 'technique = ssao, must be one of' "$plumb" $command wedge "${small[@]}" --technique ssao
  refused 'back' "$plumb" $command wedge "${small[@]}" --camera back
  refused '--width' "$plumb" $command wedge --width 0
  refused '--height' "$plumb" $command wedge --height 100000
  refused '--guard' "$plumb" $command wedge --guard 5000
done
refused '--samples = 5000, must be in [0, 4096]' "$plumb" render wedge "${small[@]}" --samples 5000
refused '--samples = -1, must be in [0, 4096]' "$plumb" render wedge "${small[@]}" --samples -1
refused 'a power of two' "$plumb" report wedge "${small[@]}" --spp 100
refused 'best' "$plumb" report wedge "${small[@]}" --budget best
refused '--rounds' "$plumb" report wedge "${small[@]}" --rounds 0

# Nothing but sky has no error.
cat >sky.json <<'J'
{"generator": "wedge",
 "cameras": [{"position_m": [0, 0, 50], "target_m": [0, 0, 100], "up": [0, 1, 0], "fov_deg": 40}]}
J
refused 'sees no surface' "$plumb" report sky.json "${small[@]}" --no-studies

# A scene file may set a technique's parameters; the command line goes before it.
cat >mine.json <<'J'
{"generator": "wedge", "techniques": [{"name": "gtao", "radius_m": 1e-4, "samples": 2}]}
J
sed 's/gtao/ssao/' mine.json >other.json
refused 'technique = ssao, must be one of' "$plumb" render other.json "${small[@]}"
"$plumb" render mine.json "${small[@]}" --technique gtao --out tiny >tiny.txt
"$plumb" render mine.json "${small[@]}" --technique gtao --radius 1 --out wide >wide.txt
cmp -s tiny/sample.png wide/sample.png && { echo "FAILED: --radius changed nothing"; failed=1; }

# Extremes that still mean something give numbers: a radius beyond the scene, one tap, a thousand,
# one pixel, eyes that touch a wall.
cat >close.json <<'J'
{"generator": "cornell_box",
 "cameras": [{"name": "inside", "position_m": [0.001, 0.2, 0.3], "target_m": [0.3, 0.3, 0.2], "fov_deg": 120}]}
J
for technique in sao-paper sao-supplement2012 sao-g3d10 alchemy hbao gtao bitmask rays-1; do
  expect 0 '' "$plumb" render wedge "${small[@]}" --technique $technique --radius 1e6 --out out --quiet
  expect 0 '' "$plumb" render wedge "${small[@]}" --technique $technique --samples 1 --out out --quiet
  expect 0 '' "$plumb" render wedge --width 1 --height 1 --technique $technique --out out --quiet
  expect 0 '' "$plumb" render close.json "${small[@]}" --technique $technique --out out --quiet
  expect 0 '' "$plumb" render wedge --width 16 --height 9 --technique $technique --samples 1000 --out out --quiet
done
left out render.exr

rm -rf out
expect 0 '' "$plumb" report box_on_plane "${small[@]}" --spp 64 --rounds 1 --no-studies --radius 0.5 \
  --out out --quiet
left out report.html report.json scores.csv sweep.csv pictures/truth_v.png pictures/gtao_error.png
grep -q '"rays-8"' out/report.json || { echo "FAILED: no rays-8 in the report"; failed=1; }
! grep -q "$dir" out/report.json || { echo "FAILED: a path of the machine in a report"; failed=1; }

[ $failed -eq 0 ] && echo "all as expected"
exit $failed
