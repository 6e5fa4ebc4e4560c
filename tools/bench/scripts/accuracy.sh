#!/usr/bin/env bash
# For developers: measures every figure and chart of docs/accuracy.md on the machine it runs on.
#   accuracy.sh BIN OUT [cuda|cpu]
# BIN has the programs. OUT gets results.json, every command with its output, tradeoff/, and accuracy.md, the tables
# that accuracy_tables.py makes of it; that script also puts them into the document, and draws its charts. Without a
# third argument: cuda if there is a usable GPU. A command that fails costs its figures alone.
# MASU_QUICK=1: few rays, to try the script. Needs python3 and gnuplot; some minutes with a GPU and 16 cores, 20 with
# two cores.
source "$(dirname "$0")/measure.sh"

limit=600
if [ "$cores" -ge 8 ]; then
  rays=$(full 30000 100) random=$(full 1000000 1000) # a step of a sweep, a scene
else
  rays=$(full 5000 100) random=$(full 100000 1000)
fi

prepare() {
  local name
  for name in "${standard[@]}"; do
    nffgen "$name" $(full '' '--size 2') | nff2bin - -o "$name.scene" -q
    gridbuild "$name.scene" -o "$name.grid" --merge irregular -q
    gridbuild "$name.scene" -o "$name-bvh.grid" --structure bvh -q
    record scenes "$name" nff2bin --info --json "$name.scene"
  done
}
stability() {
  record stability cpu gridbench stability --count "$rays" --json
  if [ "$backend" = cuda ]; then
    record stability cuda gridbench stability --count "$(full 1000 100)" --backend cuda --precision robust,double --json
  fi
}
pictures() { record pictures cpu gridbench stability --pictures --json; }
oracle() {
  local name
  for name in "${standard[@]}"; do
    record oracle "$name.grid" gridbench oracle "$name.scene" "$name.grid" --count "$random" \
      --precision fast,robust,double --json
    record oracle "$name.bvh" gridbench oracle "$name.scene" "$name-bvh.grid" --count "$random" \
      --precision fast,robust,double --json
    record oracle "$name.first" gridbench oracle "$name.scene" "$name.grid" --count "$random" \
      --precision robust --first-cell-hit --json
  done
}
tradeoff() {
  local name quick_options=(--size 32x32 --random 1000 --compared 1000 --picture 32x32 --repeat 1 --curve 4,8,16
    --divisions 16)
  rm -rf "$out/tradeoff" # measured by another program, perhaps
  for name in "${standard[@]}"; do # one after another: the last one's charts are of all
    record tradeoff "$name" gridbench tradeoff "$name.scene" -o "$out/tradeoff" --backend "$backend" --json \
      ${quick:+"${quick_options[@]}"}
  done
  ln -sfn "$out/tradeoff" tradeoff # for accuracy_tables.py
}

measure accuracy prepare stability pictures oracle tradeoff
