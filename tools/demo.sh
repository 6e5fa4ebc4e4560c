#!/usr/bin/env bash
# Installs missing packages, builds, and runs the tools once: generate, convert, build a grid, inspect, render.
# demo.sh [SCENE]: balls (default), gears, mount, nurbs, rings, teapot, tetra or tree.
set -euo pipefail
cd "$(dirname "$0")/.."
scene=${1:-balls}
source tools/setup.sh
require "${basics[@]}" -- "${extras[@]}"
find_cuda

echo "== building the programs: some two minutes on two cores"
build build -DCMAKE_BUILD_TYPE=Release -DMASU_TESTS=OFF "${cuda_options[@]}" \
  -- --target nffgen nff2bin gridbuild gridstat gridrender

bin=build/bin
out=out/$scene
mkdir -p out
run() { echo; echo "\$ $*"; "$@"; }
run $bin/nffgen "$scene" -o "$out.nff"
run $bin/nff2bin "$out.nff" -o "$out.scene" --info
run $bin/gridbuild "$out.scene" -o "$out.grid"
run $bin/gridstat "$out.grid"
run $bin/gridrender "$out.scene" "$out.grid" -o "$out.png" --stats "$out.json"
cat <<NEXT

the picture: $out.png

next, with a mesh of your own (OBJ, PLY, STL, OFF; others where there is Assimp):
  cmake --build build --parallel --target mesh2bin gridview
  $bin/mesh2bin model.obj -o out/model.scene
  $bin/gridbuild out/model.scene -o out/model.grid
  $bin/gridrender out/model.scene out/model.grid -o out/model.png
  $bin/gridview out/model.scene out/model.grid    # in a browser
NEXT
