#!/usr/bin/env bash
# Every picture of the documentation is made by tools/bench/scripts/pictures.sh: pictures_test.sh BIN. Those for which
# something is missing, which the script says, are left out.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
bin=$(cd "$1" && pwd)
docs=$(mktemp -d)
trap 'rm -rf "$docs"' EXIT
cp -r "$source/docs/." "$docs"
pictures() { (cd "$1" && find . -name '*.png' -o -name '*.jpg' -o -name '*.html') | sort; }
(cd "$docs" && pictures . | xargs rm)
"$source/tools/bench/scripts/pictures.sh" "$bin" "$docs" >"$docs/log" || { cat "$docs/log"; exit 1; }
lacking=$(comm -23 <(pictures "$source/docs") <(pictures "$docs"))
if grep -q '^charts: left out' "$docs/log"; then lacking=$(grep -vE '^./(accuracy|tradeoff)/|/peers.png|lesson/tradeoff.png' <<<"$lacking" || true); fi
if grep -q '^pictures of gridview: left out' "$docs/log"; then lacking=$(grep -vE '^./(view.jpg|cut.png|plane.png|plane.html)' <<<"$lacking" || true); fi
grep 'left out' "$docs/log" || true
[ -z "$lacking" ] || { echo "FAILED: not made:" $lacking; exit 1; }
