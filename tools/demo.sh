#!/usr/bin/env bash
# Installs missing packages, builds, and runs the tools once: generate, convert, build a hierarchy, inspect, render.
# demo.sh [SCENE]: balls (default), gears, mount, nurbs, rings, teapot, tetra or tree.
set -euo pipefail
cd "$(dirname "$0")/.."
scene=${1:-balls}
source tools/setup.sh
require "${basics[@]}" -- "${extras[@]}"
find_cuda

echo "== building the programs: a minute or two on two cores"
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

# For a mesh of one's own, and for Python, where what they need was found.
more=(masu_shared)
targets=$(cmake --build build --target help)
for program in mesh2bin gridview; do
  if [[ $targets =~ (^|[^[:alnum:]_])$program([^[:alnum:]_]|$) ]]; then more+=($program); fi
done
cat <<NEXT

the picture: $out.png

next, with a mesh of your own (OBJ, PLY, STL, OFF, glTF, FBX, …):
  cmake --build build --parallel --target ${more[*]}   # a minute on two cores
  export PATH=\$PWD/$bin:\$PATH
  mesh2bin model.obj -o out/model.scene
  gridbuild out/model.scene -o out/model.grid
  gridview out/model.scene out/model.grid         # prints an address for the browser; Ctrl+C ends it
  gridrender out/model.scene out/model.grid -o out/model.png
NEXT
