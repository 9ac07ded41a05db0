#!/usr/bin/env bash
# Makes reports as a user would, green and red, with an engine that is wrong and has a hostile name, and opens them in a real browser; reads the JUnit file with
# another language's parser. Status 4 where this machine has no browser: then nothing was looked at, and that is said.
#
#     tests/browser/run.sh [CHATTERCHECK [FOLDER FOR SCREENSHOTS]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
chattercheck=$(realpath "${1:-$here/../../target/release/chattercheck}")
shots=${2:+$(realpath -m "$2")}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# The status that a run has to have.
expect() {
  local wanted=$1 status=0
  shift
  "$@" > out.txt 2> err.txt || status=$?
  [ "$status" = "$wanted" ] || { echo "status $status, not $wanted: $*"; cat out.txt err.txt; exit 1; }
}

expect 0 "$chattercheck" verify --quiet --cases 60 --responses 0 --oracles closed-form,taylor,ode/linear/tsit45 --html green.html
expect 1 "$chattercheck" verify --quiet --cases 60 --responses 0 --oracles closed-form,ode/linear/tsit45/naive --html red.html
"$chattercheck" engine new python mine > /dev/null
python3 "$here/spoil.py" mine/engine.py
expect 1 "$chattercheck" verify --quiet --cases 100 --engines mine/engines.toml --html engine.html --junit junit.xml --summary summary.md

python3 "$here/junit.py" junit.xml
status=0
for page in green red engine; do
  python3 "$here/page.py" "$page.html" ${shots:+"$shots/$page"} || status=$?
  [ "$status" = 0 ] || exit "$status"
done
