#!/usr/bin/env bash
# Installs what is missing, builds (with CUDA where there is a toolkit), and runs every test. GPU tests run where there is a GPU;
# elsewhere they are reported as skipped.
# test.sh --full also runs the unit tests under the sanitizers, clang-tidy, and the fuzz targets for a few seconds.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/setup.sh
install_missing clang-format
cores=$(nproc)
step() { echo; echo "== $*"; }

step "format"
find libscene libgrid renderer tools tests -name '*.h' -o -name '*.cpp' -o -name '*.cu' |
  xargs clang-format --dry-run --Werror

step "build"
build build -DCMAKE_BUILD_TYPE=Release "${cuda_options[@]}"

if [ "${1:-}" = --full ]; then
  install_missing clang clang-tidy libclang-rt-dev

  step "unit tests under the sanitizers"
  build build/asan -DCMAKE_BUILD_TYPE=RelWithDebInfo -DMASU_SANITIZE=ON -DMASU_CUDA=OFF -- --target masu_unit_tests
  ctest --test-dir build/asan --output-on-failure --parallel "$cores" -L unit

  step "clang-tidy"
  find libscene libgrid renderer tools tests/stability -name '*.cpp' ! -name backend_none.cpp |
    xargs -P "$cores" -n 1 clang-tidy -p build --quiet

  step "fuzz targets, 20 s each"
  build build/fuzz -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ -DMASU_FUZZ=ON -DMASU_CUDA=OFF
  for target in build/fuzz/bin/*_fuzz; do
    "$target" -max_total_time=20 -rss_limit_mb=4096 -verbosity=0 -print_final_stats=0
  done
fi

step "tests"
ctest --test-dir build --output-on-failure --parallel "$cores"
