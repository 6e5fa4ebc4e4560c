#!/usr/bin/env bash
# For developers: time and memory of the tools by the size of the scene, as a table in Markdown.
#   scale_of_scenes.sh BIN [SIZE…]
# BIN has the programs; sizes are those of tetra (4^SIZE triangles), by default 10 11 12 13: 1 to 67 million. Each line has
# the seconds of processor (of the tool alone, user and system), elapsed seconds, the peak of resident memory, and the size
# of the file. A tool that fails is named with what it said. Needs python3, and in TMPDIR (default /tmp) 150 bytes a triangle
# and a GB; memory as the table in docs/performance.md says.
set -uo pipefail
export LC_ALL=C
[ $# -ge 1 ] || { sed -nE '2,7s/^# ?//p' "$0" >&2; exit 1; }
bin=$(cd "$1" && pwd) || exit 1
shift
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 3

# measure WHAT TRIANGLES FILE COMMAND…: runs the command, prints a line of the table.
measure() {
  python3 - "$@" <<'PYTHON'
import os, subprocess, sys, time
what, triangles, file, *command = sys.argv[1:]
began = time.monotonic()
text = os.open("text", os.O_RDONLY) if what == "nff2bin" else os.open(os.devnull, os.O_RDONLY)
process = subprocess.Popen(command, stdin=text, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
os.close(text)
said = process.stderr.read().decode().strip()
_, status, usage = os.wait4(process.pid, 0)
elapsed = time.monotonic() - began
if status:
    result = "failed: " + said.replace("|", "/")
    print(f"| {what} | {int(triangles):,} | {result} | | | |", flush=True)
else:
    size = f"{os.path.getsize(file) / 1e6:,.0f}" if file else ""
    print(f"| {what} | {int(triangles):,} | {usage.ru_utime + usage.ru_stime:.1f} | {elapsed:.1f} "
          f"| {usage.ru_maxrss * 1024 / 1e6:,.0f} | {size} |", flush=True)
PYTHON
}

echo '| tool | triangles | CPU, s | elapsed, s | peak, MB | file, MB |'
echo '| --- | --- | --- | --- | --- | --- |'
for size in "${@:-10 11 12 13}"; do
  for n in $size; do
    triangles=$((4 ** n))
    mkfifo text
    "$bin/nffgen" tetra --size "$n" >text &
    measure nff2bin $triangles s.scene "$bin/nff2bin" - -o s.scene -q
    wait
    rm text
    measure "gridbuild --merge irregular" $triangles s.grid "$bin/gridbuild" s.scene -o s.grid --merge irregular -q
    [ -e s.grid ] && measure "gridrender, 64×64 rays" $triangles "" "$bin/gridrender" s.scene s.grid -o s.pfm --size 64x64 \
      --backend cpu -q
    rm -f s.grid
    measure "gridbuild --structure bvh" $triangles s.bvh "$bin/gridbuild" s.scene -o s.bvh --structure bvh -q
    rm -f s.bvh s.scene
  done
done
