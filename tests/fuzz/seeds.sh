#!/usr/bin/env bash
# Makes seeds for the fuzz targets by the tools' own writers: seeds.sh BIN FOLDER; a folder a target. What fuzzing
# found before (tests/fuzz/found/TARGET) is among them.
set -euo pipefail
bin=$(realpath "$1") here=$(realpath "$(dirname "$0")")
mkdir -p "$2" && cd "$2"
mkdir -p nff_fuzz scene_fuzz grid_fuzz trace_fuzz mesh_fuzz list_fuzz library_fuzz
prefixed() { printf '%b' "$1"; cat; } # a byte that selects something, and the text

for scene in balls gears mount nurbs rings teapot tetra tree; do
  "$bin/nffgen" $scene --size 1 -q > $scene.nff
  head -c 60000 $scene.nff | prefixed '\200' > nff_fuzz/$scene # in small pieces
done
cat > all.nff <<'NFF'
v from 3 -4 2 at 0 0 0.5 up 0 0 1 angle 45 hither 0.1 resolution 16 12
b 0.1 0.2 0.3
l 5 -5 9 l -4 1 8 1 0.5 0.25
f 1 0.5 0.25 0.7 0.3 10 0 1
p 5 -2 -2 0 2 -2 0 2 2 0 0 0 0 -2 2 0
pp 3 0 0 1 0 0 1 1 0 1 0 0.1 1 0 1 1 0.1 0 1
f 0.2 0.4 0.9 0.6 0.4 30 0.5 1.5
s 0 0 0.5 0.5
c 1 1 0 0.5 1 1 1 0.25
NFF
prefixed '\001' < all.nff > nff_fuzz/all
for store in float32 float64; do
  "$bin/nff2bin" all.nff -o scene_fuzz/$store --store $store
  for merge in none x balance irregular; do
    for division in 1 3x4x5; do
      "$bin/gridbuild" scene_fuzz/$store -o grid_fuzz/$store-$merge-$division --merge $merge --division $division -q
    done
  done
done
"$bin/gridbuild" scene_fuzz/float32 -o grid_fuzz/blocks --merge none --division 160x4x4 -q
"$bin/nffgen" tetra --size 4 -q | "$bin/nff2bin" - -o tetra.scene -q
for quality in high fast; do # of one node, and of several levels
  "$bin/gridbuild" scene_fuzz/float32 -o grid_fuzz/bvh-$quality --structure bvh --quality $quality -q
  "$bin/gridbuild" tetra.scene -o grid_fuzz/bvh-of-tetra-$quality --structure bvh --quality $quality -q
done
if [ -x "$bin/mesh2bin" ]; then # with numbers of faces
  printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' > square.obj
  echo 'f 1 2 3 4' >> square.obj
  "$bin/mesh2bin" square.obj -o scene_fuzz/faces -q
fi
# A section of more than 4 MiB, whose hash is one of several pieces.
"$bin/nffgen" balls --size 4 -q | "$bin/nff2bin" - -o large.scene -q
"$bin/gridbuild" large.scene -o grid_fuzz/large --merge none --division 128 -q
# As many primitives as trace_fuzz's scene has.
{ grep '^[vblf]' all.nff; echo 'p 3 -2 -2 0 2 -2 0 0 2 0'; grep -A 9 '^pp' all.nff; } > four.nff
"$bin/nff2bin" four.nff -o four.scene
for merge in none x balance irregular; do
  for division in 1 3x4x5; do
    "$bin/gridbuild" four.scene -o trace_fuzz/$merge-$division --merge $merge --division $division -q
  done
done
"$bin/gridbuild" four.scene -o trace_fuzz/blocks --merge none --division 160x4x4 -q
"$bin/gridbuild" four.scene -o trace_fuzz/bvh --structure bvh -q
printf '\001{"name": "a", "from": [0, -5, 1], "at": [0, 0, 0.5], "up": [0, 0, 1], "angle": 30, "size": [64, 48]}\n{}\n' \
  > list_fuzz/views
printf "%b{'descr': '<f4', 'fortran_order': False, 'shape': (100, 6), }" '\000' > list_fuzz/npy
printf '\043# ox,oy,oz,tmin,dx,dy,dz,tmax\n1,2,3,0,4,5e-1,-6,inf\r\n\n.5,1e-400,3, 0 ,0.1,5,6,7' > list_fuzz/rays
printf '\001ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' \
  > mesh_fuzz/ply
printf '\002v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n' > mesh_fuzz/obj
printf '\012OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > mesh_fuzz/off
for seed in 1 2 3 4 5 6 7 8; do
  python3 -c "import random; random.seed($seed); print(end=''.join(map(chr, ([0] + [random.randrange(256) for _ in range(150)] + [1] + [random.randrange(256) for _ in range(12)] + [2, 0] + [6] + [random.randrange(256) for _ in range(120)]))))" |
    iconv -f utf-8 -t latin1 > library_fuzz/$seed
done
for target in *_fuzz; do
  if [ -d "$here/found/$target" ]; then cp "$here/found/$target"/* $target/; fi
done
rm -f ./*.nff ./*.scene ./*.obj
