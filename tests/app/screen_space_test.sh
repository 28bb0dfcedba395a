#!/usr/bin/env bash
# plumb render and plumb report as a user meets them: what is refused, what a small run leaves.
# Usage: screen_space_test.sh PLUMB
set -u
plumb=$1
here=$(cd "$(dirname "$0")" && pwd)
. "$(dirname "$0")/expect.sh"

small=(--width 64 --height 36)
for command in render report; do
  refused 'missing.json' "$plumb" $command missing.json
  refused 'nothing_such' "$plumb" $command make:nothing_such
  refused 'technique = ssao, must be one of' "$plumb" $command wedge "${small[@]}" --technique ssao
  refused 'back' "$plumb" $command wedge "${small[@]}" --camera back
  refused '--width' "$plumb" $command wedge --width 0
  refused '--height' "$plumb" $command wedge --height 100000
  refused '--guard' "$plumb" $command wedge --guard 5000
done
refused '--radius = 0, must be in (0, infinity)' "$plumb" report wedge "${small[@]}" --radius 0
refused '--radius = -1, must be in' "$plumb" report wedge "${small[@]}" --radius -1
refused '--radius = nan, must be in' "$plumb" report wedge "${small[@]}" --radius nan
refused '--radius = 0, must be in [1e-4, 1e7]' "$plumb" render wedge "${small[@]}" --radius 0
refused '--radius = -1, must be in [1e-4, 1e7]' "$plumb" render wedge "${small[@]}" --radius -1
refused '--radius = nan, must be in [1e-4, 1e7]' "$plumb" render wedge "${small[@]}" --radius nan
refused '--samples = 5000, must be a whole number in [1, 4096]' \
  "$plumb" render wedge "${small[@]}" --samples 5000
refused '--samples = -1, must be a whole number in [1, 4096]' \
  "$plumb" render wedge "${small[@]}" --samples -1

# --set names what it turns, or says what there is.
render_hbao=("$plumb" render wedge "${small[@]}" --technique hbao)
refused '--set hbao, must be NAME.KNOB=VALUE' "${render_hbao[@]}" --set hbao
refused 'technique = hboa, must be one of' "${render_hbao[@]}" --set hboa.slices=1
refused 'did you mean hbao?' "${render_hbao[@]}" --set hboa.slices=1
refused '--set hbao: hbao has no slice, must be one of' "${render_hbao[@]}" --set hbao.slice=1
refused 'did you mean slices?' "${render_hbao[@]}" --set hbao.slice=1
refused '--set hbao.slices = 0, must be a whole number in [1, 4096]' "${render_hbao[@]}" --set hbao.slices=0
refused '--set hbao.spread = line, must be one of screen, line_of_sight' "${render_hbao[@]}" --set hbao.spread=line
refused '--set bitmask.sectors: bitmask does not run here' "${render_hbao[@]}" --set bitmask.sectors=8

# The list of techniques is the page of the docs, and valid JSON.
"$plumb" techniques --markdown | cmp -s - "$here/../../docs/techniques.md" ||
  { echo "FAILED: docs/techniques.md is not what plumb techniques --markdown prints"; failed=1; }
"$plumb" techniques --json | python3 -c '
import json, sys
names = [t["name"] for t in json.load(sys.stdin)["techniques"]]
assert "sao-paper" in names and "rays-8" in names' || { echo "FAILED: techniques --json"; failed=1; }
"$plumb" techniques hbao | grep -q "bias_rad = 0 " || { echo "FAILED: techniques hbao"; failed=1; }
refused 'technique = hboa, must be one of' "$plumb" techniques hboa
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
{"generator": "wedge", "techniques": [{"name": "gtao-paper", "radius_m": 1e-4, "samples": 2}]}
J
sed 's/gtao-paper/ssao/' mine.json >other.json
refused 'other.json: techniques[0].name = ssao, must be one of' "$plumb" render other.json "${small[@]}"
"$plumb" render mine.json "${small[@]}" --technique gtao-paper --out tiny >tiny.txt
"$plumb" render mine.json "${small[@]}" --technique gtao-paper --radius 1 --out wide >wide.txt
cmp -s tiny/sample.png wide/sample.png && { echo "FAILED: --radius changed nothing"; failed=1; }

# Command line over scene file over default, knob by knob; --set over --samples over the file's slices.
cat >knobs.json <<'J'
{"generator": "wedge", "techniques": [{"name": "hbao", "radius_m": 0.7, "slices": 2, "steps": 3,
                                       "strength": 0.5, "attenuate": false, "filter_y": false}]}
J
same() {  # same A B: the same picture of the last pass that both have
  cmp -s "$1/sample.png" "$2/sample.png" || { echo "FAILED: $1 and $2 differ"; failed=1; }
}
hbao() {  # hbao FOLDER SCENE FLAGS...
  local folder=$1 scene=$2
  shift 2
  expect 0 '' "$plumb" render "$scene" "${small[@]}" --technique hbao --out "$folder" --quiet "$@"
}
said=(--set hbao.strength=0.5 --set hbao.attenuate=off)
hbao of_file knobs.json
hbao of_line wedge --radius 0.7 --set hbao.slices=2 --set hbao.steps=3 "${said[@]}"
same of_file of_line
[ ! -e of_file/blur_y.png ] && [ -e of_line/blur_y.png ] || { echo "FAILED: filter_y of the file"; failed=1; }
hbao more knobs.json --samples 24
hbao more_line wedge --radius 0.7 --samples 24 "${said[@]}"
same more more_line
hbao most knobs.json --samples 24 --set hbao.slices=5
hbao most_line wedge --radius 0.7 --set hbao.slices=5 --samples 24 "${said[@]}"
same most most_line
cmp -s of_file/sample.png more/sample.png && { echo "FAILED: --samples changed nothing"; failed=1; }
cmp -s more/sample.png most/sample.png && { echo "FAILED: --set changed nothing"; failed=1; }

# The same in report: what the file says, what --radius and --set say over it.
report_hbao() {  # report_hbao FOLDER SCENE FLAGS...
  local folder=$1 scene=$2
  shift 2
  expect 0 '' "$plumb" report "$scene" "${small[@]}" --technique hbao --no-studies --spp 16 --rounds 1 \
    --out "$folder" --quiet "$@"
}
same_report() {
  cmp -s "$1/pictures/hbao.png" "$2/pictures/hbao.png" || { echo "FAILED: reports $1 and $2 differ"; failed=1; }
}
slices=(--set hbao.slices=2 --set hbao.steps=3 --set hbao.filter_y=off "${said[@]}")
report_hbao r_file knobs.json
report_hbao r_line wedge "${slices[@]}" --set hbao.radius_m=0.7
same_report r_file r_line
report_hbao r_over knobs.json --radius 1 --set hbao.slices=3
report_hbao r_over_line wedge --radius 1 "${slices[@]}" --set hbao.slices=3
same_report r_over r_over_line
cmp -s r_file/pictures/hbao.png r_over/pictures/hbao.png && { echo "FAILED: report heard no flag"; failed=1; }
refused '--set bitmask.sectors: bitmask does not run here' \
  "$plumb" report wedge "${small[@]}" --technique hbao --no-studies --set bitmask.sectors=8

# Extremes that still mean something give numbers: a radius beyond the scene, one tap, a thousand,
# one pixel, eyes that touch a wall.
cat >close.json <<'J'
{"generator": "cornell_box",
 "cameras": [{"name": "inside", "position_m": [0.001, 0.2, 0.3], "target_m": [0.3, 0.3, 0.2], "fov_deg": 120}]}
J
for technique in sao-paper sao-supplement2012 sao-g3d10 alchemy hbao gtao-paper gtao-xegtao bitmask rays-1; do
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
left out report.html report.json report.csv scores.csv pictures/truth_v.png pictures/gtao-xegtao_error.png
grep -q '"rays-8"' out/report.json || { echo "FAILED: no rays-8 in the report"; failed=1; }
! grep -q "$dir" out/report.json || { echo "FAILED: a path of the machine in a report"; failed=1; }

[ $failed -eq 0 ] && echo "all as expected"
exit $failed
