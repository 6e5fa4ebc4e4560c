#!/usr/bin/env bash
# Makes the figures and tables of docs/lesson.md: lesson.sh [FOLDER], by default out/lesson; the tools are taken from
# build/bin, or BIN. Takes two minutes on one core. THREADS (default 1): of the CPU, for measurements. MASU_QUICK=1: one run
# each, of few rays, for figures alone.
set -euo pipefail
cd "$(dirname "$0")/.."
charts=$PWD/tools/bench/charts
bin=$(cd "${BIN:-build/bin}" && pwd)
out=${1:-out/lesson}
threads=${THREADS:-1}
mkdir -p "$out"
cd "$out"
PATH=$bin:$PATH
divisions="2 4 8 16 32 64 128"
repeat="--warm-up 1 --repeat 7" medians=3 size=256x256
hits=() # of section 7: its views' size
if [ "${MASU_QUICK:-}" ]; then repeat="--warm-up 0 --repeat 1" medians=1 size=64x64 hits=(--size 64x64); fi
section() { printf '\n== %s\n' "$*"; }
run() { echo; echo "\$ $*"; "$@"; }

# What a camera ray costs in grids of a scene, on the CPU: a table, and in NAME.dat a line per grid with the division (of
# SCENE-N.grid), tests, cells and nanoseconds per ray: the least of three medians, for a machine that isn't idle.
cost() { # name, scene, grid…
  local name=$1
  shift
  echo
  echo "\$ gridbench rays $* --sets primary --size $size --backend cpu --threads $threads $repeat"
  for _ in $(seq $medians); do
    # shellcheck disable=SC2086 # options
    gridbench rays "$@" --sets primary --size $size --backend cpu --threads "$threads" $repeat --json
  done |
    awk -F '[:,]' '
      function number() { return $2 + 0 }
      /"grid":/ { grid = $2; gsub(/[" ]/, "", grid) }
      /"count":/ { count = number() }
      /"median_seconds":/ { seconds = number() }
      /"tests_a_ray":/ { tests[grid] = number() }
      /"cells_a_ray":/ { cells[grid] = number() }
      /"empty_cells_a_ray":/ { empty[grid] = number() }
      /}/ && seconds > 0 {
        if (!(grid in time)) order[++n] = grid
        if (!(grid in time) || 1e9 * seconds / count < time[grid]) time[grid] = 1e9 * seconds / count
        seconds = 0
      }
      END {
        printf "%-24s %13s %13s %12s %12s\n", "grid", "tests per ray", "cells per ray", "empty", "ns per ray"
        for (i = 1; i <= n; ++i) {
          g = order[i]
          printf "%-24s %13.2f %13.2f %12.2f %12.0f\n", g, tests[g], cells[g], empty[g], time[g]
          split(g, name, /[-.]/)
          print name[2], tests[g], cells[g], time[g] >"'"$name"'.dat"
        }
      }'
}

# Columns of gridstat --csv by name, a line a grid.
columns() { # names, grid…
  local names=$1 grid
  shift
  for grid in "$@"; do
    gridstat "$grid" --csv | awk -F, -v grid="$grid" -v names="$names" '
      NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
      { n = split(names, name, " "); line = sprintf("%-16s", grid)
        for (i = 1; i <= n; ++i) line = line sprintf(($at[name[i]] ~ /^[0-9]+$/ ? " %14d" : " %14.5g"), $at[name[i]])
        print line }'
  done
}
heads() { printf '%-16s' grid; printf ' %14s' "$@"; echo; }

section "1. Scenes"
for scene in teapot balls; do
  nffgen $scene | nff2bin - -o $scene.scene >/dev/null
  for n in $divisions; do gridbuild -q $scene.scene -o "$scene-$n.grid" --division "$n"; done
done
run gridrender -q teapot.scene teapot-32.grid -o teapot.png --size 160x160 --backend cpu

section "2. A uniform grid's trade-off"
grids() { for n in $divisions; do echo "$1-$n.grid"; done; }
for scene in teapot balls; do
  heads voxels occupied_% references a_cell bytes
  # shellcheck disable=SC2046 # words
  columns "voxels occupancy_percent references references_per_occupied_cell.mean bytes.file" $(grids $scene)
  # shellcheck disable=SC2046
  cost $scene $scene.scene $(grids $scene)
done
if command -v gnuplot >/dev/null; then
  gnuplot -e "out='tradeoff.png'" "$charts/style.gp" "$charts/lesson.gp"
  echo "tradeoff.png"
else
  echo "tradeoff.png: left out (it needs gnuplot)"
fi
# Slices that are compared have one scale; three stand side by side, so they are small.
for n in 8 32; do
  gridstat teapot-$n.grid --slice y@0 --outline teapot.scene --lines --size 240 --color-high 339 -o uniform-$n.png \
    --title "uniform, $n x $n x $n"
done
gridstat teapot-128.grid --slice y@0 --size 240 --color-high 339 -o uniform-128.png --title "uniform, 128 x 128 x 128"

section "3. Occupancy"
# The 2012 thesis's scenes: without floors and the spheres of mount.
for scene in "teapot 6" "tetra 6" "mount 6" "nurbs 5" "balls 4" "tree 11" "rings 7"; do
  # shellcheck disable=SC2086 # words
  set -- $scene
  more=--no-background
  if [ "$1" = teapot ]; then more=; fi # the squares count
  # shellcheck disable=SC2086
  nffgen "$1" --size "$2" $more | nff2bin - -o "occupancy-$1.scene" >/dev/null
  run gridstat --occupancy "occupancy-$1.scene" --divisions 2,4,8,16,32,64,128
done

section "4. Merged voxels"
for scene in teapot balls; do
  gridbuild -q $scene.scene -o $scene-x.grid --division 32 --merge x
  gridbuild -q $scene.scene -o $scene-balance.grid --division 32 --merge balance
  division=13x13x5; if [ $scene = balls ]; then division=50x50x3; fi # of the lesson's figures
  gridbuild -q $scene.scene -o $scene-irregular.grid --merge irregular --division $division
  heads cells occupied references a_cell bytes
  columns "cells occupied_cells references references_per_occupied_cell.mean bytes.file" \
    $scene-32.grid $scene-x.grid $scene-balance.grid $scene-irregular.grid
  cost merged-$scene $scene.scene $scene-32.grid $scene-x.grid $scene-balance.grid $scene-irregular.grid
done
gridstat teapot-x.grid --slice y@0.9 --outline teapot.scene --lines --size 480 --color-high 39 -o merged-x.png \
  --title "merged along x, 32 x 32 x 32"
gridstat teapot-balance.grid --slice y@0.9 --outline teapot.scene --lines --size 480 --color-high 39 -o merged-balance.png \
  --title "merged by balance, 32 x 32 x 32"

section "5. Irregular grids"
run gridstat teapot-irregular.grid
gridstat teapot-32.grid --slice y@0 --outline teapot.scene --lines --size 480 --color-high 155 -o uniform.png \
  --title "uniform, 32 x 32 x 32: references"
gridstat teapot-irregular.grid --slice y@0 --outline teapot.scene --lines --size 480 --color-high 155 -o irregular.png \
  --title "irregular: references"
gridstat teapot-irregular.grid --slice y@0 --outline teapot.scene --lines --size 480 -o irregular-depth.png \
  --color depth --title "irregular: depth of nesting"
gridstat teapot-irregular.grid --slice y@0 --outline teapot.scene --lines --size 480 -o irregular-spout.png \
  --window 2,1,3.6,2.6 --title "irregular: the spout"
run gridstat teapot-irregular.grid --cells cells.ply --occupied

section "6. What a ray costs, and its walk"
for grid in 32 irregular; do
  run gridrender -q teapot.scene teapot-$grid.grid -o rays-$grid.png --channels cells --channel-high 72 \
    --no-picture --size 160x160 --sampling centers --backend cpu
done
run gridtrace -q teapot.scene teapot-32.grid --pixel 150,120 --size 256x256 --sampling centers
run gridtrace -q teapot.scene teapot-irregular.grid --pixel 150,120 --size 256x256 --sampling centers

section "7. The same hits from every grid"
for grid in teapot-2 teapot-128 teapot-x teapot-balance teapot-irregular; do
  gridrender -q teapot.scene $grid.grid --hits $grid.hits "${hits[@]}" --backend cpu
done
gridrender -q teapot.scene --brute-force --hits brute-force.hits --size 64x64 --backend cpu
gridrender -q teapot.scene teapot-32.grid --hits teapot-64x64.hits --size 64x64 --backend cpu
run cmp teapot-2.hits teapot-128.hits && run cmp teapot-2.hits teapot-irregular.hits
cmp teapot-2.hits teapot-x.hits && cmp teapot-2.hits teapot-balance.hits && cmp brute-force.hits teapot-64x64.hits
sha256sum ./*.hits

section "8. A hierarchy"
for scene in teapot balls; do
  gridbuild -q $scene.scene -o $scene-bvh.grid --structure bvh
  cost hierarchy-$scene $scene.scene $scene-bvh.grid
done
for structure in 32 irregular bvh; do
  run gridrender teapot.scene teapot-$structure.grid -o idle-$structure.png --channels idle --no-picture \
    --size 256x256 --sampling centers --backend cpu
done
