#!/usr/bin/env bash
# The subcommand of docs/extending.md as its user meets it. Usage: slopes_test.sh PLUMB_EXTENDED
set -u
plumb=$1
. "$(dirname "$0")/../../app/expect.sh"

expect 0 '' "$plumb" --help
grep -q '^  slopes ' stdout || { echo "FAILED: slopes is not in the help"; failed=1; }

# The ramp z = x of 3 x 3 texels, a row a line: every facet has a slope of 45 degrees.
floats() { printf '\0\0\0\0\0\0\200\077\0\0\0\100'; }
{ printf 'Pf\n3 3\n-1.0\n'; floats; floats; floats; } >ramp.pfm
printf '{"spacing_m": 1, "boundary": "open"}' >ramp.json
expect 0 '' "$plumb" slopes ramp.pfm --out ramp
left ramp report.html report.json report.csv
grep -q '^slopes,15,share,,1,,,$' ramp/report.csv || { echo "FAILED: not all above 15 degrees"; cat ramp/report.csv; failed=1; }
grep -q '^slopes,60,share,,0,,,$' ramp/report.csv || { echo "FAILED: some above 60 degrees"; failed=1; }
refused 'missing.png' "$plumb" slopes missing.png

[ $failed -eq 0 ] && echo "all as expected"
exit $failed
