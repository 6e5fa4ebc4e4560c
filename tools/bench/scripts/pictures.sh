#!/usr/bin/env bash
# Makes every picture of the documentation: pictures.sh BIN DOCS. BIN has the programs. DOCS gets the lesson's figures, the
# charts of the tables and rows that it has (gnuplot), plane.html, and pictures of gridview's page (Chromium, Selenium), which are left out
# where those aren't. PYTHON: a python3 with Selenium. Takes a minute on two cores.
set -euo pipefail
[ $# = 2 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 1; }
here=$(cd "$(dirname "$0")" && pwd)
bin=$(cd "$1" && pwd) docs=$(cd "$2" && pwd)
python=${PYTHON:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

BIN=$bin MASU_QUICK=1 "$here/../../../examples/lesson.sh" "$work" >"$work/log"
mkdir -p "$docs/lesson"
for picture in teapot uniform{,-8,-32,-128} irregular{,-depth,-spout} merged-{x,balance} rays-{32,irregular}.cells idle-{32,irregular,bvh}.idle; do
  cp "$work/$picture.png" "$docs/lesson/"
done
if command -v gnuplot >/dev/null; then
  "$python" -B "$here/charts.py" "$docs" "$bin/gridbench"
else
  echo "charts: left out (they need gnuplot)"
fi
if [ -x "$bin/gridview" ]; then
  # The lesson's plane as a file, with the rays of its links.
  (cd "$work" && PATH=$bin:$PATH gridview teapot.scene teapot-{balance,irregular,bvh,x}.grid --export plane.html -q \
    --views 1 --size 120x90 --boxes 100 --slices y,0.5 y,0.6125 \
    --rays=-3.9,0,2.9,7.6,0,-1.4 --rays=-3.9,0,1,7.8,0,0 --rays=-3.9,0.9,2.9,7.8,0,-0.3)
  cp "$work/plane.html" "$docs/"
fi
if [ -x "$bin/gridview" ] && command -v chromium >/dev/null && "$python" -c 'import selenium' 2>/dev/null; then
  "$python" -B "$here/../../../tests/view/pictures.py" "$bin" "$docs"
else
  echo "pictures of gridview: left out (they need gridview, Chromium and Selenium)"
fi
