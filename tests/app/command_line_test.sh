#!/usr/bin/env bash
# The program as a user meets it: what is refused, with which status and words, and that nothing is
# left half-written. Usage: command_line_test.sh PLUMB
set -u
plumb=$1
docs=$(cd "$(dirname "$0")/../../docs" && pwd)
. "$(dirname "$0")/expect.sh"

printf 'not a picture' >fake.png
: >empty.png
printf '\377\330\377\340\0\020JFIF\0\001\001' >photo.png
printf 'Pf\n1 1\n-1.0\n\0\0\0\0' >one.pfm
printf 'Pf\n3 1\n-1.0\n\0\0\0\0\0\0\0\0\0\0\0\0' >row.pfm
printf 'Pf\n2 2\n-1.0\n\0\0\0\0\0\0\300\177\0\0\0\0\0\0\0\0' >nan.pfm
{ printf 'Pf\n3 3\n-1.0\n'; head -c 36 /dev/zero; } >flat.pfm
printf 'Pf\n40000 40000\n-1.0\n' >huge.pfm

refused 'Run with --help' "$plumb"
refused 'missing.png' "$plumb" simulate missing.png
refused 'fake.png' "$plumb" simulate fake.png
refused 'empty.png' "$plumb" simulate empty.png
refused 'photo.png' "$plumb" simulate photo.png
refused 'at least 2 x 2' "$plumb" simulate one.pfm
refused 'at least 2 x 2' "$plumb" simulate row.pfm
refused 'nan.pfm' "$plumb" simulate nan.pfm
refused 'huge.pfm' "$plumb" simulate huge.pfm
refused 'nothing to fit' "$plumb" fit flat.pfm
refused 'must be > 0' "$plumb" simulate flat.pfm --spacing-m 0
refused 'must be finite and > 0' "$plumb" simulate make:bricks:16 --amplitude-m -1
refused '--amplitude-m 1e+200' "$plumb" simulate make:bricks:16 --amplitude-m 1e200
refused 'relief over spacing' "$plumb" fit make:bricks:16 --amplitude-of-width 1e6
refused 'in [1e-30, 1e30]' "$plumb" simulate make:bricks:16 --spacing-m 1e-310
refused 'in [0, 1]' "$plumb" simulate make:bricks:16 --albedo 1.5
refused 'in [4, 65536]' "$plumb" simulate make:bricks:16 --slices 0
refused 'in [0, 1000]' "$plumb" simulate make:bricks:16 --bounces 1001
refused '--histogram' "$plumb" fit
# By its header: 64 channels of 16 x 16 texels.
printf 'Pf\n2000 2000\n-1.0\n' >albedo.pfm
refused 'at most 16384 numbers' "$plumb" simulate make:bricks:16 --albedo-map albedo.pfm

# Seeds that a reader of unsigned numbers would take for others.
for command in 'simulate make:bricks:16' 'fit make:bricks:16' 'truth cornell_box' \
  'render cornell_box --technique gtao-paper' 'report cornell_box' 'bench ao' 'bench light'; do
  for seed in -1 18446744073709551616 1.5 0x10 '' 1e3; do
    # shellcheck disable=SC2086
    refused '--seed' "$plumb" $command --seed "$seed"
  done
done

# A full disk and a folder that cannot be made are the machine's fault.
touch file
expect 3 'file' "$plumb" simulate make:bricks:16 --slices 4 --out file/out --quiet

# What it is for, at the smallest size.
expect 0 '' "$plumb" simulate make:bricks:16 --slices 4 --albedo 0.8 0.5 0.3 --out out --quiet
left out light.exr light_albedo.exr light_albedo.png report.html report.json \
  histogram_alpha.csv histogram_alpha.json histogram_v.csv histogram_v.json
for file in out/*; do
  grep -qF -- "$(basename "$file" | sed 's/^bricks_/NAME_/')" "$docs/light.md" ||
    { echo "FAILED: $file is not in docs/light.md"; failed=1; }
done
expect 0 '' "$plumb" fit make:bricks:24 make:cobbles:24 --slices 4 --no-studies --bootstrap 10 \
  --out fitted --quiet
left fitted report.html report.json report.csv scores.csv constants.csv plumb_light.glsl plumb_light.hlsl \
  plumb_light.h
! grep -q "$dir" fitted/report.json || { echo "FAILED: a path of the machine in a report"; failed=1; }

# Maps of one name, and jobs without --out, do not overwrite each other's files.
mkdir m1 m2
for folder in m1 m2; do
  printf 'Pf\n8 8\n-1.0\n' >$folder/wall.pfm
  # Heights of 0, 1/8 and 1/4 m, one digit a texel.
  for k in 01220100 12221010 02210000 00100122 10001222 00000122 11000010 00012000; do
    printf "$(printf %s $k | sed 's/0/\\0\\0\\0\\0/g; s/1/\\0\\0\\0\\76/g; s/2/\\0\\0\\200\\76/g')"
  done >>$folder/wall.pfm
done
expect 0 '' "$plumb" fit m1/wall.pfm m2/wall.pfm --slices 4 --no-studies --bootstrap 0 --quiet
left out/fit report.html maps/m1_wall_v.png maps/m2_wall_v.png
grep -q '^plain V,m1/wall,' out/fit/scores.csv && grep -q '^plain V,m2/wall,' out/fit/scores.csv ||
  { echo "FAILED: the maps have no names of their own"; failed=1; }
before=$(cat out/fit/constants.csv)
expect 0 '' "$plumb" simulate m1/wall.pfm --slices 4 --quiet
left out/simulate report.html histogram_alpha.csv
expect 0 '' "$plumb" fit --histogram out/simulate/histogram_alpha.csv --quiet
left out/fit-histogram report.html report.json report.csv constants.csv
[ "$before" = "$(cat out/fit/constants.csv)" ] || { echo "FAILED: another job's constants"; failed=1; }

# A name that no file system takes with an ending behind it.
long=$(printf 'n%.0s' $(seq 251))
cp m1/wall.pfm "$long.pfm"
expect 0 '' "$plumb" simulate "$long.pfm" --slices 4 --quiet --out long
expect 0 '' "$plumb" fit "$long.pfm" m1/wall.pfm --slices 4 --no-studies --bootstrap 0 --starts 1 \
  --quiet --out long-fit
printf '{"generator": "wedge"}' >"$(printf 's%.0s' $(seq 250)).json"
expect 0 '' "$plumb" report "$(printf 's%.0s' $(seq 250)).json" --no-studies --width 16 \
  --height 12 --spp 16 --rounds 1 --technique hbao --quiet
left "$(echo out/report-sss*)" report.html

# A column alpha does not say what open ground receives.
printf 'alpha,E0,E1\n0.2,0.66,0.5\n0.5,1.7,0.6\n0.8,2.7,0.3\n0.9,2.9,0.2\n0.95,3.0,0.1\n' >pi.csv
refused '--open-ground' "$plumb" fit --histogram pi.csv
refused 'taken to be 1' "$plumb" fit --histogram pi.csv --open-ground 1
expect 0 '' "$plumb" fit --histogram pi.csv --open-ground pi --quiet

# The rasterizer's sizes are the program's own, so this takes a few seconds.
refused 'must be one of' "$plumb" bench raster make:nothing
refused 'not in range 1 to 16384' "$plumb" bench raster --width 0
refused 'not in range 5 to 1000' "$plumb" bench raster --rounds 4
expect 0 '' "$plumb" bench raster make:cornell_box --width 64 --height 48 --rounds 5 --out bench --quiet
left bench report.html report.json report.csv

[ $failed -eq 0 ] && echo "all as expected"
exit $failed
