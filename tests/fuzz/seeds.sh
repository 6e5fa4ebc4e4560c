#!/usr/bin/env bash
# Makes seeds for the fuzz targets by the tools' own writers: seeds.sh BIN FOLDER; a folder a target. What fuzzing
# found before (tests/fuzz/found/TARGET) is among them.
set -euo pipefail
bin=$(realpath "$1") here=$(realpath "$(dirname "$0")")
mkdir -p "$2" && cd "$2"
mkdir -p nff_fuzz scene_fuzz grid_fuzz trace_fuzz mesh_fuzz mesh_file_fuzz list_fuzz library_fuzz
prefixed() { printf '%b' "$1"; cat; } # a byte that selects something, and the text

grids_of() { # a scene, what its grids' names begin with
  for merge in none x balance irregular; do
    for division in 1 3x4x5; do
      "$bin/gridbuild" "$1" -o "$2$merge-$division" --merge $merge --division $division -q
    done
  done
}

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
  grids_of scene_fuzz/$store grid_fuzz/$store-
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
grids_of four.scene trace_fuzz/
"$bin/gridbuild" four.scene -o trace_fuzz/blocks --merge none --division 160x4x4 -q
"$bin/gridbuild" four.scene -o trace_fuzz/bvh --structure bvh -q
printf '\001{"name": "a", "from": [0, -5, 1], "at": [0, 0, 0.5], "up": [0, 0, 1], "angle": 30, "size": [64, 48]}\n{}\n' \
  > list_fuzz/views
printf "%b{'descr': '<f4', 'fortran_order': False, 'shape': (100, 6), }" '\000' > list_fuzz/npy
printf '\043# ox,oy,oz,tmin,dx,dy,dz,tmax\n1,2,3,0,4,5e-1,-6,inf\r\n\n.5,1e-400,3, 0 ,0.1,5,6,7' > list_fuzz/rays
printf '\000{"asset":{"version":"2.0"},"extensionsRequired":["KHR_lights_punctual"],"scenes":[{"nodes":[0]}],"nodes":[{}]}' \
  > mesh_fuzz/gltf
printf '\012 0 0 0 1 0 0 0 1 0\n' > mesh_fuzz/raw
# The first byte of mesh_file_fuzz: 0 for OBJ, 2 for PLY, 4 for OFF, 6 for STL; 1 more for smooth normals.
vertices=$(printf 'v %s\n' '0 0 0' '1 0 .5 1 0 0' '1 1 0' '0 1 0 1')
printf '\001mtllib m\nnewmtl m\nKd 1 0 0\nKs 1 1 1\nNs 9\nNi 1.5\nd 0.5\nillum 4\nmap_Kd a\n%s\nvn 0 0 1\nusemtl m\nf 1//1 2//1 3//1\no b\nf -4/1 -3 -2/1/ \\\n -1 # x\nl 1 2\n' \
  "$vertices" > mesh_file_fuzz/obj
ply_header() { # format, type of coordinates, another property
  printf 'ply\nformat %s 1.0\nelement vertex 3\n' "$1"
  printf "property $2 %s\n" x y z "$3"
  printf 'element edge 1\nproperty int a\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n'
}
zeros() { head -c "$1" /dev/zero; }
{ printf '\002'; ply_header ascii double red; printf '0 0 0 1\n1 0 0 1\n0 1 0 1\n7\n3 0 1 2\n'; } > mesh_file_fuzz/ply
{ printf '\003'; ply_header binary_little_endian float nx; zeros 52; printf '\003\0\0\0\0\001\0\0\0\002\0\0\0'; } \
  > mesh_file_fuzz/ply-little
{ printf '\002'; ply_header binary_big_endian double w; zeros 100; printf '\003\0\0\0\0\0\0\0\001\0\0\0\002'; } > mesh_file_fuzz/ply-big
printf '\004OFF\n3 1 0 # counts\n0 0 0\n# a comment\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n' > mesh_file_fuzz/off
printf '\005STCN4OFF 3 1\n0 0 0 1 0 0 1 9 9 9\n1 0 0 1 0 0 1 9 9 9\n0 1 0 1 0 0 1 9 9 9\n3 0 1 2\n' > mesh_file_fuzz/off-all
facet='facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n'
printf '\006solid a b\n%bendsolid\nSOLID\n%bENDSOLID\n' "$facet" "$facet" > mesh_file_fuzz/stl
{ printf '\006solid COLOR=abcd'; zeros 64; printf '\001\0\0\0'; zeros 48; printf '\001\200'; } > mesh_file_fuzz/stl-binary
for seed in 1 2 3 4 5 6 7 8; do
  python3 -c "import random; random.seed($seed); print(end=''.join(map(chr, ([0] + [random.randrange(256) for _ in range(150)] + [1] + [random.randrange(256) for _ in range(12)] + [2, 0] + [6] + [random.randrange(256) for _ in range(120)]))))" |
    iconv -f utf-8 -t latin1 > library_fuzz/$seed
done
for target in *_fuzz; do
  if [ -d "$here/found/$target" ]; then cp "$here/found/$target"/* $target/; fi
done
rm -f ./*.nff ./*.scene ./*.obj
