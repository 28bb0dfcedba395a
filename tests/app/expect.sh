# What the tests of the command line share: a folder of their own, and what they expect.
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 1
failed=0

# expect STATUS WORDS COMMAND...: the status, and the words somewhere on standard error.
expect() {
  local status=$1 words=$2
  shift 2
  "$@" >stdout 2>stderr
  local got=$?
  if [ $got -ne "$status" ]; then
    echo "FAILED: status $got, not $status: $*"
    cat stderr
    failed=1
  elif [ -n "$words" ] && ! grep -qF -- "$words" stderr; then
    echo "FAILED: no '$words' on standard error of: $*"
    cat stderr
    failed=1
  fi
}

# refused WORDS COMMAND...: status 2, the words, and no output folder.
refused() {
  rm -rf out
  expect 2 "$@"
  [ ! -e out ] || { echo "FAILED: something was written by: $*"; failed=1; }
}

# left FOLDER FILE...: each file is there and not empty.
left() {
  local folder=$1 name
  shift
  for name in "$@"; do
    [ -s "$folder/$name" ] || { echo "FAILED: no $folder/$name"; failed=1; }
  done
}
