#!/usr/bin/env bash
# Installs missing packages, builds (with CUDA where there is a toolkit), and runs all tests. GPU tests are skipped where
# there is no GPU. test.sh --full also runs those labelled slow, which need 6 GB of memory and of disk.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/setup.sh
require "${basics[@]}" libgtest-dev -- "${tests[@]}" "${extras[@]}"
find_cuda

echo "== building programs and tests: some three minutes on two cores, with CUDA five more"
build build -DCMAKE_BUILD_TYPE=Release -DMASU_TESTS=ON "${cuda_options[@]}"

echo "== tests"
slow=()
[ "${1:-}" = --full ] && slow=(-C slow)
ctest --test-dir build --output-on-failure --parallel "$(nproc)" "${slow[@]}"
