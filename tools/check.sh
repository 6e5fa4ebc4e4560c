#!/usr/bin/env bash
# For developers: static checks. Formatting, and a build with warnings as errors; check.sh --full also runs the unit
# tests under sanitizers, clang-tidy, and each fuzz target for 20 seconds.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/setup.sh
export MASU_STRICT=ON
require "${basics[@]}" libgtest-dev clang-format -- "${extras[@]}" "${benchmarks[@]}"
find_cuda
cores=$(nproc)
step() { echo; echo "== $*"; }

# Other versions format differently and warn of other things.
llvm=14
version_of() { "$1" --version | sed -nE 's/.*version ([0-9]+).*/\1/p' | head -n 1; }
require_llvm() { # program…
  local program
  for program in "$@"; do
    [ "$(version_of "$program")" = $llvm ] && continue
    echo "$0: $program is version $(version_of "$program"), the checks need version $llvm (Debian 12's)" >&2
    exit 1
  done
}

step "format"
require_llvm clang-format
find api examples libscene libgrid renderer tools tests -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.cu' |
  xargs clang-format --dry-run --Werror

step "build, warnings as errors"
build build -DCMAKE_BUILD_TYPE=Release -DMASU_TESTS=ON "${cuda_options[@]}"

if [ "${1:-}" = --full ]; then
  require clang clang-tidy libclang-rt-dev
  require_llvm clang++ clang-tidy

  step "unit tests under the sanitizers"
  build build/asan -DCMAKE_BUILD_TYPE=RelWithDebInfo -DMASU_SANITIZE=ON -DMASU_CUDA=OFF -- \
    --target masu_unit_tests masu_cairo_assimp_tests masu_library_tests
  LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/lsan.supp print_suppressions=0" \
    ctest --test-dir build/asan --output-on-failure --parallel "$cores" -L unit

  step "unit tests under ThreadSanitizer"
  tests/sanitizers/tsan_tbb.sh build/tbb
  build build/tsan -DCMAKE_BUILD_TYPE=RelWithDebInfo -DMASU_SANITIZE=thread -DMASU_CUDA=OFF -- \
    --target masu_unit_tests masu_cairo_assimp_tests masu_library_tests
  # A quarter of the random cases: races don't hide in particular ones.
  MASU_TEST_EFFORT=0.25 TSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/tsan.supp ignore_noninstrumented_modules=1 halt_on_error=1" \
    ctest --test-dir build/tsan --output-on-failure --parallel "$cores" -L unit

  step "clang-tidy"
  build build/tidy -DMASU_UNITY=OFF "${cuda_options[@]}" -- --target masu_schemas # a command for each source
  find api libscene libgrid renderer tools -name '*.cpp' ! -name '*_none.cpp' |
    xargs -P "$cores" -n 1 clang-tidy -p build/tidy --quiet

  step "fuzz targets, 20 s each"
  build build/fuzz -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ -DMASU_FUZZ=ON -DMASU_CUDA=OFF -- \
    --target fuzz
  rm -rf build/fuzz/seeds
  tests/fuzz/seeds.sh build/bin build/fuzz/seeds
  # Without mesh_fuzz: the first that it finds are Assimp's own faults.
  for target in nff scene grid trace list library mesh_file; do
    dictionary=tests/fuzz/$target.dict
    "build/fuzz/bin/${target}_fuzz" -max_total_time=20 -rss_limit_mb=4096 -verbosity=0 -print_final_stats=0 \
      $([ ! -f $dictionary ] || echo -dict=$dictionary) build/fuzz/seeds/${target}_fuzz
  done
fi
