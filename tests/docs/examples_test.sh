#!/usr/bin/env bash
# Installs the library into a temporary folder, moves it, and builds and runs the examples as a project of its own there,
# with flags unlike Masu's: examples_test.sh BUILD [gpu|source]. PYTHON: a python3 with NumPy. Without gpu what needs a GPU
# is built, where there is nvcc, and not run; with it nothing else is run, and 77 is returned where there is no GPU. With
# source the examples take the library's source in instead, in a folder in BUILD.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$1
which=${2:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
step() { echo; echo "== $*"; }

if [ "$which" = gpu ] && ! nvidia-smi -L 2>/dev/null | grep -q GPU; then
  echo "skipped: no GPU"
  exit 77
fi

if [ "$which" = source ]; then
  step "with add_subdirectory"
  # What BUILD has of the same sources isn't compiled again, and nobody knows then which headers it depends on: so
  # nothing is kept from run to run. The rest isn't optimized.
  rm -rf "$build/examples_from_source"
  cmake -S "$source/examples" -B "$build/examples_from_source" -DMASU_SOURCE=.. -DCMAKE_CUDA_COMPILER=NOTFOUND \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
    ${PYTHON:+-DCMAKE_CXX_COMPILER_LAUNCHER="$PYTHON;-B;$source/tests/docs/built_object.py;$build;examples_from_source/masu"}
  cmake --build "$build/examples_from_source" --parallel "$(nproc)"
  ctest --test-dir "$build/examples_from_source" --output-on-failure --no-tests=error
  [ -z "$(find "$build/examples_from_source" -type f -name 'grid*' -perm -u+x)" ] # the tools aren't built
  exit
fi

step "install"
for component in library development python; do
  cmake --install "$build" --prefix "$folder/first" --component $component >"$folder/log" || { cat "$folder/log"; exit 1; }
done
mv "$folder/first" "$folder/masu" # an installation may be moved
find "$folder/masu" ! -type d | sort

configure() { # folder, option…
  local into=$1
  shift
  cmake -S "$source/examples" -B "$into" -DCMAKE_PREFIX_PATH="$folder/masu" "$@"
  cmake --build "$into"
}

if [ "$which" = gpu ]; then
  step "the example of CUDA"
  configure "$folder/gpu"
  ctest --test-dir "$folder/gpu" --output-on-failure --no-tests=error -L gpu
  exit
fi

step "with find_package and plain flags"
configure "$folder/plain" -DCMAKE_C_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Werror" \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Wconversion -Werror"
ctest --test-dir "$folder/plain" --output-on-failure --no-tests=error -LE gpu

step "with other flags"
configure "$folder/other" -DCMAKE_C_FLAGS="-O0 -ffast-math -std=c99 -funsigned-char" -DCMAKE_CUDA_COMPILER=NOTFOUND \
  -DCMAKE_CXX_FLAGS="-O0 -ffast-math -fno-rtti -march=native"
ctest --test-dir "$folder/other" --output-on-failure --no-tests=error
[ "$(wc -c <"$folder/other/torus.pgm")" = 76815 ]

if command -v pkg-config >/dev/null; then
  step "with pkg-config"
  mkdir "$folder/pkg-config"
  cd "$folder/pkg-config"
  pc=$(find "$folder/masu" -name masu.pc)
  export PKG_CONFIG_PATH=${pc%/*}
  # shellcheck disable=SC2046 # words
  cc -std=c99 "$source/examples/depth.c" -o depth $(pkg-config --cflags --libs masu) -lm
  LD_LIBRARY_PATH=$(pkg-config --variable=libdir masu) ./depth
  [ "$(wc -c <torus.pgm)" = 76815 ]
else
  echo "left out: pkg-config isn't installed"
fi

if [ -n "${PYTHON:-}" ]; then
  step "Python"
  mkdir "$folder/python"
  cd "$folder/python"
  PYTHONPATH=$folder/masu/lib/python3/dist-packages "$PYTHON" "$source/examples/lidar.py" | tee log
  grep -q '^[1-9][0-9]* of 288000 beams' log
  [ "$(sed -n 's/^element vertex //p' sweep.ply)" = "$(sed 's/ .*//' log)" ]
  PYTHONPATH=$folder/masu/lib/python3/dist-packages "$PYTHON" "$source/examples/robots.py" cpu 8 2
  [ "$(wc -c <scan.pgm)" = 129615 ]
else
  echo "left out: the example of Python (without Python 3 and NumPy)"
fi
