# Sourced by performance.sh and accuracy.sh, whose arguments are BIN OUT [cuda|cpu]: their set-up, and how they record
# what they run. Working folder: a temporary one, with raw/ for what commands print.
set -uo pipefail
export LC_ALL=C
[ $# -ge 2 ] || { sed -nE '2,/^source/s/^# ?//p' "$0" >&2; exit 1; }
here=$(cd "$(dirname "$0")" && pwd)
bin=$(cd "$1" && pwd) && mkdir -p "$2" && out=$(cd "$2" && pwd) || exit 1
export PATH=$bin:$PATH
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 3
mkdir raw
cores=$(nproc)
quick=${MASU_QUICK:+1}
full() { if [ "$quick" ]; then echo "$2"; else echo "$1"; fi; } # an option of the full measurement, of the quick one

nffgen tetra --size 1 | nff2bin - -o probe.scene -q || exit 2
backend=${3:-$(gridbuild probe.scene -o probe.grid --device cuda -q 2>probe.err && echo cuda || echo cpu)}
standard=(balls gears mount rings teapot tetra tree)

# record SECTION KEY COMMAND…: runs the command, keeps what it prints and took (measured.py). At most `limit` seconds
# (120).
record() { python3 -B "$here/measured.py" "${limit:-120}" "$@"; }
at_once() { xargs -P "$cores" -d '\n' -I{} bash -c '{}'; } # lines of standard input as commands, one a core

machine() {
  {
    echo "commit=$(for tool in nffgen nff2bin grid{build,stat,render,trace,bench}; do "$tool" --version; done |
      sed -nE 's/.*\(commit (.*)\)/\1/p' | sort -u | paste -sd ' ')"
    echo "date=$(date -u +%F)"
    echo "backend=$backend"
    echo "cpu=$(sed -nE '0,/^model name/s/^model name\s*: //p' /proc/cpuinfo)"
    echo "cores=$cores"
    if [ "$backend" = cuda ]; then
      echo "device=$(gridbuild probe.scene -o probe.grid --merge none --device cuda --json -q |
        sed -nE 's/.*"device":"([^"]*)".*/\1/p')"
      echo "driver=$(nvidia-smi --query-gpu=driver_version --format=csv,noheader | head -n 1)"
    fi
    echo "quick=$quick"
  } >machine.txt
}

# measure NAME SECTION…: runs the sections, functions, and makes the tables by NAME_tables.py.
measure() {
  machine
  local document=$1 section
  shift
  for section in "$@"; do
    echo "[$SECONDS s] $section" >&2
    $section
    # After each section: a script that is ended early leaves what it has measured.
    python3 -B "$here/${document}_tables.py" "$out/results.json" --gather . >"$out/$document.md"
  done
  echo "[$SECONDS s] done: $out/$document.md" >&2
}
