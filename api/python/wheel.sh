#!/usr/bin/env bash
# Builds the Python module's wheel into dist/, or another folder: wheel.sh [FOLDER]. Installs missing packages. With nvcc
# the wheel traces on GPUs, too; MASU_CUDA=OFF leaves that out. CMAKE_ARGS: more options of cmake.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tools/setup.sh
require "${basics[@]}" patchelf python3-build -- ninja-build
find_cuda
export CMAKE_ARGS="${cuda_options[0]} ${CMAKE_ARGS:-}"
folder=$(realpath -m "${1:-dist}")
pyproject-build --wheel --no-isolation --outdir "$folder"
ls -l "$folder"/masu-*.whl
