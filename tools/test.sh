#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test: the release build's (with CUDA where there is a toolkit), the CPU
# code's under the address and undefined-behaviour sanitizers, the fuzz targets for a few seconds, and the style checks.
# GPU tests run where there is a GPU; elsewhere they are reported as skipped.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/setup.sh
install_missing clang clang-format clang-tidy libclang-rt-dev
cores=$(nproc)

step() { echo; echo "== $*"; }
step "format"
git ls-files '*.h' '*.cpp' '*.cu' | xargs clang-format --dry-run --Werror

step "release build"
build build -DCMAKE_BUILD_TYPE=Release "${cuda_options[@]}"

step "sanitizer build"
build build/asan -DCMAKE_BUILD_TYPE=RelWithDebInfo -DMASU_SANITIZE=ON -DMASU_CUDA=OFF

step "fuzz targets, 20 s each"
build build/fuzz -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ -DMASU_FUZZ=ON -DMASU_CUDA=OFF
for target in build/fuzz/bin/*_fuzz; do
  "$target" -max_total_time=20 -rss_limit_mb=4096 -verbosity=0 -print_final_stats=0
done

step "clang-tidy"
git ls-files 'libscene/*.cpp' 'libgrid/*.cpp' 'renderer/*.cpp' 'tools/*.cpp' | grep -v backend_none |
  xargs -P "$cores" -n 1 clang-tidy -p build --quiet 2>/dev/null

step "tests under the sanitizers"
ctest --test-dir build/asan --output-on-failure --parallel "$cores" -L unit

step "tests"
ctest --test-dir build --output-on-failure --parallel "$cores"
