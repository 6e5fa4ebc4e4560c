#!/usr/bin/env bash
# Installs what is missing, builds (with CUDA where there is a toolkit), and runs every test. GPU tests run where there
# is a GPU; elsewhere they are reported as skipped.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/setup.sh
require "${basics[@]}" libgtest-dev -- gnuplot-nox ninja-build
find_cuda

echo "== building programs and tests: some three minutes on two cores, with CUDA five more"
build build -DCMAKE_BUILD_TYPE=Release -DMASU_TESTS=ON "${cuda_options[@]}"

echo "== tests"
ctest --test-dir build --output-on-failure --parallel "$(nproc)"
