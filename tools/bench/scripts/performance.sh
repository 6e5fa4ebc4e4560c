#!/usr/bin/env bash
# For developers: measures every figure of docs/performance.md and the README's results on the machine it runs on.
#   performance.sh BIN OUT [cuda|cpu]
# BIN has the programs. OUT gets results.json, every command with its output, and performance.md, the tables that
# performance_tables.py makes of it; that script also puts them into the documents. Without a third argument: cuda if
# there is a usable GPU; without one, sections that need it are left out. A command that fails costs its figures alone.
# MASU_SECTIONS="prepare embree": only these. MASU_QUICK=1: tiny sizes, to try the script.
# MASU_SCENES: more scene files for the section choice, as full paths, with spaces between. Needs python3, and 4 GB in
# TMPDIR (default /tmp). The last sections aren't run unless they are named: embree (masu_cpu_rays), library, answer,
# closest and placed (PYTHON, an interpreter with NumPy, with a GPU PyTorch), scale (10 GB of memory and disk), gpus (several GPUs).
source "$(dirname "$0")/measure.sh"

devices=$(if [ "$backend" = cuda ]; then echo cuda cpu; else echo cpu; fi)
size=$(full 1024x1024 64x64)
warm_up=1 repeat=3 # untimed runs, and timed ones of which the median counts
[ "$backend" = cuda ] && warm_up=10 repeat=25
[ "$quick" ] && warm_up=0 repeat=1
large=(teapot-60 mount-10-triangles tetra-9 tetra-10 balls-triangles rings-triangles tree-triangles)

# A line for each scene: its name, the options of nffgen, those of nff2bin.
scenes() {
  local name
  for name in "${standard[@]}"; do echo "$name:$name $(full '' '--size 2'):"; done
  for name in balls-5 mount-8 teapot-60 mount-10 tetra-9 tetra-10; do
    echo "$name:${name%-*} --size $(full "${name#*-}" 3):"
  done
  for name in balls rings tree; do echo "$name-triangles:$name $(full '' '--size 2'):--tessellate 12"; done
  echo "mount-10-triangles:mount --size $(full 10 3):--tessellate 12"
}

prepare() {
  scenes | while IFS=: read -r name made converted; do
    echo "nffgen $made | nff2bin - -o $name.scene -q $converted"
  done | at_once
  for name in "${standard[@]}"; do
    for made in '.grid --structure grid' .chosen.grid '-bvh.grid --structure bvh' '.irregular.grid --merge irregular' \
      '.none-32.grid --merge none --division 32' '.none-auto.grid --merge none --division auto'; do
      echo "gridbuild $name.scene -q --threads 1 -o $name$made"
    done
  done | at_once
  for name in balls-5 mount-8 mount-10; do gridbuild $name.scene -o $name.grid -q --structure grid; done
  for scene in *.scene; do record scenes "${scene%.scene}" nff2bin --info --json "$scene"; done
}

builds() {
  local name device run
  for name in "${large[@]}"; do
    for device in $devices; do
      for run in 1 2 3; do
        record builds "$name.$device.$run" gridbuild "$name.scene" -o "built.$device" --merge irregular \
          --device "$device" --json -q
      done
    done
    [ -e built.cuda ] && record builds "$name.same" cmp built.cuda built.cpu
    [ -e "$name.grid" ] || cp built.cpu "$name.grid"
    record builds "$name.one.1" gridbuild "$name.scene" -o built.one --merge irregular --threads 1 --json -q
    rm -f built.*
  done
}

# picture SECTION KEY SCENE GRID OUTPUT OPTION…
picture() {
  record "$1" "$2" gridrender "$3.scene" "$4.grid" -o "$5" --size "$size" --sampling centers --times - -q "${@:6}"
}

pictures() {
  local name
  for name in "${standard[@]}"; do
    picture pictures "$name.chosen" "$name" "$name.chosen" chosen.pfm --backend "$backend" --repeat $repeat
    picture pictures "$name.uniform" "$name" "$name.none-auto" uniform.pfm --backend "$backend" --repeat $repeat
    record pictures "$name.same" cmp chosen.pfm uniform.pfm
  done
}
one_core() {
  for name in "${standard[@]}"; do
    picture one_core "$name" "$name" "$name.chosen" one.pfm --backend cpu --threads 1 --repeat "$(full 3 1)"
  done
}
views() {
  picture views png mount-10 mount-10 'view-{index}.png' --turntable "$(full 200 5)" --backend "$backend"
  rm -f view-*.png
}

# What `gridbuild --structure fastest` may consider, and the rates of rays through each.
choice() {
  local scene name i structure division options
  for scene in "$@"; do
    name=$(basename "$scene" .scene)
    for structure in grid fastest; do
      record choice "$processor.$name.$structure" gridbuild "$scene" -o choice.grid --structure "$structure" \
        --for "$processor" --json -q
    done
    python3 -c 'import json, sys
grids, fastest = (json.load(open(path)).get("considered", []) for path in sys.argv[1:])
for i, one in enumerate([*grids, *(one for one in fastest if one["structure"] == "bvh")]):
    print(i, one["structure"], "x".join(map(str, one["division"])))' \
      "raw/choice.$processor.$name."{grid,fastest}.out >considered.txt
    while read -r i structure division; do
      options="--merge ${structure/uniform/none} --division $division"
      [ "$structure" = bvh ] && options="--structure bvh"
      # shellcheck disable=SC2086 # options are a list
      gridbuild "$scene" -o choice.grid -q $options </dev/null
      record choice "$processor.$name.$i" gridbench rays "$scene" choice.grid --sets primary,diffuse,random --json \
        "${rays[@]}" --warm-up "$(full 3 0)" --repeat "$(full 9 1)" </dev/null
    done <considered.txt
  done
}
choices() {
  local processor rays
  processor=gpu rays=(--backend cuda --size "$size" --random "$(full 1048576 1000)")
  # shellcheck disable=SC2086 # MASU_SCENES is a list
  [ "$backend" = cuda ] && choice "${standard[@]/%/.scene}" "${large[@]/%/.scene}" ${MASU_SCENES:-}
  processor=cpu rays=(--backend cpu --size "$(full 256x256 32x32)" --random "$(full 262144 1000)")
  choice "${standard[@]/%/.scene}"
}
rays() {
  local loops
  loops=$(if [ "$backend" = cuda ]; then echo auto,thread_per_ray,warp,warp_refill; else echo auto,thread_per_ray; fi)
  for name in "${large[@]}" balls gears rings tree; do
    [ -e "$name-bvh.grid" ] || gridbuild "$name.scene" -o "$name-bvh.grid" --structure bvh -q
    record rays "$name" gridbench rays "$name.scene" "$name.grid" "$name-bvh.grid" --loop "$loops" \
      --backend "$backend" --json --size "$size" --random "$(full 4194304 1000)" --warm-up $warm_up --repeat $repeat
  done
}
fastest() {
  for name in "${standard[@]}" "${large[@]}"; do
    record fastest "$name" gridbuild "$name.scene" -o fastest.built --structure fastest --json -q
  done
}
hierarchies() {
  local name grid
  for name in "${standard[@]}" "${large[@]}"; do
    for grid in "$name" "$name-bvh"; do
      picture hierarchies "$grid" "$name" "$grid" p.pfm --backend "$backend" --repeat $repeat
    done
  done
}
cells() {
  for name in "${standard[@]}"; do
    for grid in .none-{32,auto} .irregular -bvh; do
      [ -e "$name$grid.grid" ] || continue
      record cells "$name$grid" gridrender "$name.scene" "$name$grid.grid" --backend cpu \
        --size "$(full 256x256 32x32)" --spd-rules --stats - -q
    done
  done
}
load() { for run in 0 1 2 3; do picture load $run mount-10 mount-10 mount-10.pfm --backend "$backend"; done; } # 0 warms up

# --- Unless named, not run --------------------------------------------------------------------------------------------

# On the CPU beside Embree: triangles alone.
embree() {
  local limit=600 name
  for name in teapot-60 mount-10-triangles tetra-9 tetra-10 balls-triangles gears rings-triangles tree-triangles; do
    [ -e "$name-bvh.grid" ] || gridbuild "$name.scene" -o "$name-bvh.grid" --structure bvh -q
    # shellcheck disable=SC2046 # options
    record embree "$name" masu_cpu_rays "$name.scene" "$name-bvh.grid" --repeat "$(full 15 1)" \
      $(full '' '--size 32x32 --random 1000')
  done
}
module() { # COMMAND…: with the Python module
  PYTHONPATH=$here/../../../api/python MASU_LIBRARY=${MASU_LIBRARY:-$bin/../api/libmasu.so} "$@"
}
library() {
  local limit=600 name
  for name in teapot-60 balls tetra-9 mount-10; do
    gridbuild $name.scene -o library.grid -q
    record library $name.gridbench gridbench rays $name.scene library.grid --sets primary,diffuse,random --save rays. \
      --size "$size" --random "$(full 1048576 1000)" --backend "$backend" --warm-up $warm_up --repeat $repeat --json
    module record library $name "${PYTHON:-python3}" -B "$here/library.py" rates $name.scene library.grid rays.
    rm -f rays.*
  done
}
by_size() { # SECTION COUNT…: of so many triangles or placements
  local device count
  for device in $devices; do
    for count in "${@:2}"; do
      module record "$1" "$device.$count" "${PYTHON:-python3}" -B "$here/library.py" "$1" "$count" "$device"
    done
  done
}
# shellcheck disable=SC2046 # lists
answer() { by_size answer $(full '20000 200000 2000000 8000000' 1000); } # on a GPU, too, what its memory holds
# shellcheck disable=SC2046
closest() { by_size closest $(full '20000 200000 2000000' 1000); }
# shellcheck disable=SC2046
placed() {
  local devices=$backend
  by_size placed $(full 10000 20)
  by_size moves $(full '4096 131072' 20)
}
# Time and memory by the size of the scene.
scale() {
  local limit=3600 n
  for n in $(full '10 11 12 13' '2 3'); do
    nffgen tetra --size "$n" | record scale "$n.nff2bin" nff2bin - -o scale.scene -q
    record scale "$n.irregular" gridbuild scale.scene -o scale-"$n".irregular.grid --merge irregular -q
    record scale "$n.gridrender" gridrender scale.scene scale-"$n".irregular.grid -o scale.pfm --size 64x64 --backend cpu -q
    record scale "$n.bvh" gridbuild scale.scene -o scale-"$n".bvh.grid --structure bvh -q
    mv scale.scene scale-"$n".scene
    for file in scale-"$n".*; do truncate -r "$file" "$file.size" && mv "$file.size" "$file"; done # its size alone is kept
  done
}
# Views, and one large view, by one GPU, two, and so on; on a CPU by threads.
gpus() {
  local limit=600 n workers
  for n in $(python3 -c "n = 1
while n <= $(if [ "$backend" = cuda ]; then nvidia-smi -L | wc -l; else echo "$cores"; fi): print(n); n *= 2"); do
    workers=(--threads "$n")
    [ "$backend" = cuda ] && workers=(--devices "$(seq -s, 0 $((n - 1)))")
    for run in 1 2 3; do
      record gpus "views.$n.$run" gridrender mount-10.scene mount-10.grid -o 'view-{index}.png' --turntable "$(full 400 4)" \
        --size "$size" --backend "$backend" "${workers[@]}" --times -
      record gpus "large.$n.$run" gridrender mount-10.scene mount-10.grid -o view-0.png --size "$(full 16384x16384 256x256)" \
        --backend "$backend" "${workers[@]}" --times -
      rm -f view-*.png
    done
  done
}

sections="prepare builds pictures one_core views cells load rays fastest hierarchies choices"
# shellcheck disable=SC2086 # a list
measure performance ${MASU_SECTIONS:-$sections}
