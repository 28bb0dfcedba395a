#!/usr/bin/env bash
# The comparison of the README's tables with a run's output: what agrees passes, every kind of
# disagreement is told. Usage: figures_test.sh FIGURES
set -u
figures=$1
. "$(dirname "$0")/expect.sh"

cat >scores.csv <<'E'
formula,map,rms,low,high
"plain, alpha",one,9,9,9
"plain, alpha",all,0.21289,-0.104,0.3
plain V,all,0.15284,1234.5,
E
# table ROW...: a document whose table has these rows.
table() {
  printf '%s\n' 'text' '<!-- figures: scores.csv' 'where: map = all' \
    'columns: formula, -, rms, low (high to rms)' 'rows: plain, alpha; plain V -->' \
    '| formula | time | rms | held |' '| --- | --- | --- | --- |' "$@" '' 'more' >table.md
}
good1='| **plain α** | 7 s | 0.2129 | −0.10 (0.3 to 0.21) |'
good2='| plain V | 8 s | 0.153 | 1235 |'

# differs WORDS: status 1, and the words on standard output.
differs() {
  "$figures" table.md >stdout && { echo "FAILED: nothing differs, not '$1'"; failed=1; }
  grep -qF -- "$1" stdout || { echo "FAILED: no '$1' in:"; cat stdout; failed=1; }
}

table "$good1" "$good2"
differs 'row "plain V", column "held": no number for high'
good2='| plain V | 8 s | 0.153 | 1234.5 (0 to 0.2) |'
table "$good1" "$good2"
differs 'but high of scores.csv is missing'
sed -i 's/1234.5,$/1234.5,0/' scores.csv
expect 0 '' "$figures" table.md
grep -q '8 figures of 1 tables compared, 0 differ' stdout || { cat stdout; failed=1; }

table '| **plain α** | 7 s | 0.2128 | −0.10 (0.3 to 0.21) |' "$good2"
differs 'row "plain, alpha", column "rms": 0.2128, but rms of scores.csv is 0.21289'
table '| **plain α** | 7 s | 0.2129 | 0.10 (0.3 to 0.21) |' "$good2"
differs 'column "held": 0.10, but low of scores.csv is -0.104'
table '| **plain α** | 7 s | 0.2129 | −0.10 (0.3 to 0.22) |' "$good2"
differs 'column "held": 0.22'
table "$good1"
differs 'the table has 1 rows, its comment 2'
table "$good1" "$good2" "$good2"
differs 'the table has 3 rows, its comment 2'
table "$good1" '| plain V | 8 s | 0.153 |'
differs 'row "plain V"'
table "$good1" "$good2"
sed -i 's/plain V -->/plain W -->/' table.md
differs 'has no row "plain W"'
table "$good1" "$good2"
sed -i 's/-, rms/-, rmse/' table.md
differs 'has no column rmse'
table "$good1" "$good2"
sed -i 's/map = all/map = two/' table.md
differs 'has no row "plain, alpha"'
table "$good1" "$good2"
rm scores.csv
differs 'scores.csv: is missing or empty'
printf 'no table\n' >table.md
differs 'has no table that is marked'

[ $failed -eq 0 ] && echo "all as expected"
exit $failed
