#!/usr/bin/env bash
# plumb truth as a user meets it: what is refused, and that a run that was killed goes on to the same
# bytes as one that was not. Usage: truth_test.sh PLUMB
set -u
plumb=$1
[ -x "$plumb" ] || { echo "FAILED: no program $plumb"; exit 1; }
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 1
failed=0
fail() { echo "FAILED: $*"; failed=1; }

# refused WORDS COMMAND...: status 2, the words on standard error, and no output folder.
refused() {
  local words=$1
  shift
  rm -rf out
  "$@" >stdout 2>stderr
  local got=$?
  [ $got -eq 2 ] || { fail "status $got, not 2: $*"; cat stderr; }
  grep -qF -- "$words" stderr || { fail "no '$words' on standard error of: $*"; cat stderr; }
  [ ! -e out ] || fail "something was written by: $*"
}

camera='"position_m": [0, -3, 1], "target_m": [0, 0, 0]'
triangle='v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'
printf "$triangle" >good.obj
printf 'mtllib t.mtl\nusemtl cloth\n'"$triangle" >textured.obj
printf 'newmtl cloth\nmap_Kd gone.png\n' >t.mtl
printf 'v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >nan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >beyond.obj
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >beyond.off
printf 'v 0 0 0\n' >empty.obj
# scene NAME MESH FOV MORE: a scene file with one mesh and one camera.
scene() { echo "{\"meshes\": [{\"file\": \"$2\"}], \"cameras\": [{$camera, \"fov_deg\": $3$4}]}" >"$1"; }
for mesh in gone.obj textured.obj nan.obj beyond.obj beyond.off empty.obj; do
  scene "$mesh.json" "$mesh" 60 ''
  refused "$mesh" "$plumb" truth "$mesh.json"
done
refused 'gone.png' "$plumb" truth textured.obj.json
scene narrow.json good.obj 0 ''
refused 'cameras[0].fov_deg = 0, must be in (0, 180)' "$plumb" truth narrow.json
scene wide.json good.obj 180 ''
refused 'cameras[0].fov_deg = 180, must be in (0, 180)' "$plumb" truth wide.json
scene none.json good.obj 60 ', "width_px": 0, "height_px": 0'
refused 'width_px = 0' "$plumb" truth none.json
scene huge.json good.obj 60 ', "width_px": 100000, "height_px": 100000'
refused 'width_px = 100000' "$plumb" truth huge.json
scene good.json good.obj 60 ''
refused 'gone.json' "$plumb" truth gone.json
refused 'must be one of' "$plumb" truth sponza
refused '--width' "$plumb" truth cornell_box --width 0
refused '--height' "$plumb" truth cornell_box --height 100000
refused 'at most 2^28' "$plumb" truth cornell_box --width 60000 --height 60000
refused '--target-error' "$plumb" truth cornell_box --target-error 0
refused 'power of two' "$plumb" truth cornell_box --spp 100
refused '--seconds' "$plumb" truth cornell_box --seconds 0
refused 'albedo = 2' "$plumb" truth cornell_box --bounces 2 --albedo 2
refused '--falloff' "$plumb" truth cornell_box --falloff steep
refused 'must be one of' "$plumb" truth cornell_box --camera gone
refused 'is missing' "$plumb" truth cornell_box --resume
"$plumb" truth good.json --width 16 --height 16 --spp 64 --out fine --quiet || fail "a good scene"

# The same bytes after kill -9 in the middle and --resume.
run=("$plumb" truth cornell_box --width 56 --height 48 --irradiance --beauty --spp 1024 --quiet)
# in_the_middle SIGNAL FOLDER: sends the signal to a run that has kept its first state. Its status.
in_the_middle() {
  "${run[@]}" --out "$2" &
  local pid=$!
  for _ in $(seq 1200); do
    [ -n "$(find "$2/cache" -name '*.state' 2>/dev/null)" ] && break
    sleep 0.05
  done
  kill "$1" $pid
  wait $pid 2>/dev/null
}
"${run[@]}" --out whole || fail "the run that is not killed"
in_the_middle -KILL killed
status=$?
[ $status -eq 137 ] || fail "status $status after kill -9"
[ ! -e killed/truth.exr ] || fail "the run had ended before it was killed"
"${run[@]}" --out killed --resume || fail "going on after kill -9"
for name in truth.exr truth.html truth.json truth.csv truth.png truth_irradiance.png truth_beauty.png; do
  cmp "whole/$name" "killed/$name" || fail "$name differs after kill -9 and --resume"
done

# Ctrl-C: status 130, pictures of what there is, and the way on.
in_the_middle -INT stopped
status=$?
[ $status -eq 130 ] || fail "status $status after an interrupt, not 130"
grep -q '^truth,,stopped_by,,interruption,' stopped/truth.csv || fail "the reason is not in the report"
"${run[@]}" --out stopped --resume || fail "going on after an interrupt"
cmp whole/truth.exr stopped/truth.exr || fail "truth.exr differs after an interrupt and --resume"

# Ctrl-C is heard within two seconds of both threads' work, however many samples there are: the
# processor's time is counted, which others on the machine do not take away.
ticks() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$1/stat" 2>/dev/null || echo 0; }
# stops_soon COMMAND...: interrupted once it has computed for two seconds.
stops_soon() {
  "$@" >stdout 2>stderr &
  local pid=$! second before after status
  second=$(getconf CLK_TCK)
  until [ "$(ticks $pid)" -ge $((2 * second)) ]; do
    kill -0 $pid 2>/dev/null || { fail "ended before it was interrupted: $*"; return; }
    sleep 0.05
  done
  before=$(ticks $pid)
  after=$before
  kill -INT $pid
  while kill -0 $pid 2>/dev/null && [ -r /proc/$pid/stat ]; do
    local now
    now=$(ticks $pid)
    [ "${now:-0}" -gt "$after" ] && after=$now
    [ $((after - before)) -gt $((60 * second)) ] && kill -KILL $pid
    sleep 0.02
  done
  wait $pid
  status=$?
  [ $status -eq 130 ] || fail "status $status, not 130, after an interrupt: $*"
  [ $((after - before)) -le $((4 * second)) ] ||
    fail "$((after - before)) ticks of $second from the interrupt to the end: $*"
}
stops_soon "$plumb" truth atrium --facets --spp 1048576 --bounces 3 --out slow
stops_soon "$plumb" truth atrium --facets --spp 1048576 --out slow
stops_soon "$plumb" truth atrium --width 64 --height 64 --irradiance --beauty --spp 1073741824 --no-cache --out slow
stops_soon "$plumb" render atrium --technique rays-8 --samples 4096 --out slow

# Every triangle, in a table: a head and one line each.
refused 'a power of two' "$plumb" truth wedge --facets --spp 100
"$plumb" truth wedge --facets --spp 16 --bounces 1 --out facets --quiet || fail "facets"
[ "$(wc -l <facets/facets.csv)" -eq 6401 ] || fail "$(wc -l <facets/facets.csv) lines in facets.csv"

[ $failed -eq 0 ] && echo "all as expected"
exit $failed
