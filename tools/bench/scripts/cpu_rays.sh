#!/usr/bin/env bash
# For developers: closest hits on this machine's CPU by Masu and by Embree, for the table of docs/performance.md.
#   cpu_rays.sh BIN OUT [option of masu_cpu_rays…]
# BIN has the programs, masu_cpu_rays among them. OUT keeps scenes, grids and what masu_cpu_rays prints for each; the
# table goes to standard output.
set -euo pipefail
export LC_ALL=C
[ $# -ge 2 ] || { sed -nE '2,5s/^# ?//p' "$0" >&2; exit 1; }
bin=$(cd "$1" && pwd) && mkdir -p "$2" && cd "$2"
shift 2
export PATH=$bin:$PATH

# A line for each scene: its name, the options of nffgen, those of nff2bin.
scenes='teapot-60:teapot --size 60:
mount-10:mount --size 10:--tessellate 12
tetra-9:tetra --size 9:
tetra-10:tetra --size 10:
balls:balls:--tessellate 12
gears:gears:
rings:rings:--tessellate 12
tree:tree:--tessellate 12'

# From what masu_cpu_rays prints: of each set, on one thread and on all, Masu's rate, Embree's and their ratio; of primary
# rays then the rate of Embree's packets.
row() { # name, file
  awk -v name="$1" '
    $1 ~ /^(primary|diffuse|random)$/ && ($2 == "1" || $2 == "all") && $NF != "-" {
      key = $2 " " $1
      if ($5 == "packets") packets[key] = $(NF - 1)
      else if ($3 == "Embree") embree[key] = $(NF - 1)
      else { masu[key] = $(NF - 1); ratio[key] = $NF }
    }
    END {
      printf "| %s |", name
      for (t = 1; t <= 2; ++t) for (s = 1; s <= 3; ++s) {
        key = (t == 1 ? "1 " : "all ") (s == 1 ? "primary" : s == 2 ? "diffuse" : "random")
        printf " %s, %s (%s) |", masu[key], embree[key], ratio[key]
        if (s == 1) printf " %s |", packets[key]
      }
      print ""
    }' "$2"
}

echo "| scene | one core: primary | packets | diffuse | random | all cores: primary | packets | diffuse | random |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
while IFS=: read -r name generate convert; do
  # shellcheck disable=SC2086
  [ -e "$name.scene" ] || nffgen $generate </dev/null | nff2bin - -o "$name.scene" -q $convert
  [ -e "$name.grid" ] || gridbuild "$name.scene" --structure bvh -o "$name.grid" -q </dev/null
  masu_cpu_rays "$name.scene" "$name.grid" "$@" >"$name.txt" </dev/null
  row "$name" "$name.txt"
done <<<"$scenes"
