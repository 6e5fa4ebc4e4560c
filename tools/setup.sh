# Sourced by demo.sh, test.sh and check.sh: installs missing packages, finds CUDA, builds.

# What a Debian package provides, by which it is found from whatever source: a command or a header.
declare -A commands=([clang]=clang++ [flatbuffers-compiler]=flatc [gnuplot-nox]=gnuplot [libopenmpi-dev]=mpicc
  [ninja-build]=ninja [openmpi-bin]=mpirun [python3-build]=pyproject-build)
declare -A headers=([libassimp-dev]=assimp/scene.h [libbenchmark-dev]=benchmark/benchmark.h [libcairo2-dev]=cairo/cairo.h
  [libcli11-dev]=CLI/CLI.hpp [libcpp-httplib-dev]=httplib.h [libflatbuffers-dev]=flatbuffers/flatbuffers.h
  [libfmt-dev]=fmt/format.h [libgmp-dev]=gmpxx.h [libgtest-dev]=gtest/gtest.h [libisal-dev]=isa-l/igzip_lib.h
  [libpng-dev]=png.h [libtbb-dev]=tbb/tbb.h [libturbojpeg0-dev]=turbojpeg.h [libxxhash-dev]=xxhash.h
  [nlohmann-json3-dev]=nlohmann/json.hpp [zlib1g-dev]=zlib.h)
has() { # package
  header() { if command -v c++ >/dev/null; then echo "#include <$1>" | c++ -E -x c++ - >/dev/null 2>&1; else false; fi; }
  if [ -n "${commands[$1]:-}" ]; then command -v "${commands[$1]}" >/dev/null; return; fi
  if [ -n "${headers[$1]:-}" ]; then header "${headers[$1]}"; return; fi
  case $1 in
    build-essential) command -v c++ >/dev/null && command -v make >/dev/null ;;
    clang-format | clang-tidy | cmake | file | help2man | patchelf | pkg-config) command -v "$1" >/dev/null ;;
    libembree-dev) header embree4/rtcore.h || header embree3/rtcore.h ;;
    python3-numpy) python3 -c 'import numpy' 2>/dev/null || /usr/bin/python3 -c 'import numpy' 2>/dev/null ;;
    python3-venv) python3 -c 'import ensurepip' 2>/dev/null ;;
    *) dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed' ;;
  esac
}

missing_of() { # package…
  local package
  for package in "$@"; do has "$package" || echo "$package"; done
}

# require PACKAGE… [-- PACKAGE…]: packages after -- are optional. Installs missing packages where it may; otherwise
# prints how to install them.
require() {
  local required=() useful=() missing root=() log
  while [ $# -gt 0 ] && [ "$1" != -- ]; do required+=("$1"); shift; done
  [ $# -gt 0 ] && shift
  useful=("$@")
  required=($(missing_of "${required[@]}")) # no process substitution: /dev/fd may be missing
  useful=($(missing_of "${useful[@]}"))
  missing=("${required[@]}" "${useful[@]}")
  [ ${#missing[@]} -gt 0 ] || return 0
  local command="apt-get install -y --no-install-recommends"
  if [ "$(id -u)" -ne 0 ]; then root=(sudo); fi
  if command -v apt-get >/dev/null &&
      { [ ${#root[@]} -eq 0 ] || { command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; }; }; then
    echo "== installing, which takes minutes: ${missing[*]}"
    log=$(mktemp) # shown only where it fails: of packages' own messages nothing is to be done
    if ! { "${root[@]}" apt-get update -qq &&
        "${root[@]}" env DEBIAN_FRONTEND=noninteractive $command -o Dpkg::Use-Pty=0 -qq "${missing[@]}"; } >"$log" 2>&1; then
      cat "$log" >&2
      rm -f "$log"
      exit 1
    fi
    rm -f "$log"
  elif [ ${#required[@]} -gt 0 ]; then
    echo "$0: missing, and only root can install it: sudo $command ${required[*]}" >&2
    exit 1
  else
    echo "== continuing without ${useful[*]} (sudo $command ${useful[*]})"
  fi
}

basics=(build-essential cmake flatbuffers-compiler fonts-dejavu-core libcairo2-dev libcli11-dev libflatbuffers-dev
  libfmt-dev libisal-dev libpng-dev libtbb-dev libxxhash-dev nlohmann-json3-dev zlib1g-dev)
benchmarks=(libbenchmark-dev libembree-dev) # for masu_cpu_rays and gridbench stability
# file: for cpack; help2man: for man pages
# libgmp-dev: for exact hits; patchelf, python3-venv: for wheels of the Python module
tests=(file gnuplot-nox help2man libgmp-dev patchelf python3-numpy python3-venv) # beside libgtest-dev, which all of them need
# libassimp-dev: for mesh2bin; libcpp-httplib-dev, libturbojpeg0-dev, pkg-config: for gridview, and of them the last two
# for JPEG pictures; libopenmpi-dev, openmpi-bin: for gridrender-mpi and gridtrace-mpi
extras=(libassimp-dev libcpp-httplib-dev libopenmpi-dev libturbojpeg0-dev ninja-build openmpi-bin pkg-config)

# Sets cuda_options for cmake. Without a GPU kernels are built only where MASU_CUDA=ON asks for that: they take most of
# the time, and nothing there can run them.
find_cuda() {
  # CUDA's installer doesn't add nvcc to the PATH.
  if ! command -v nvcc >/dev/null && [ -x /usr/local/cuda/bin/nvcc ]; then PATH=$PATH:/usr/local/cuda/bin; fi
  local architecture # of this machine's GPU; no PTX for others
  architecture=$( (nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null || true) | head -n 1 | tr -d .)
  cuda_options=(-DMASU_CUDA=OFF)
  if [ "${MASU_CUDA:-AUTO}" = OFF ]; then
    echo "== MASU_CUDA=OFF: building for the CPU only"
  elif ! command -v nvcc >/dev/null; then
    echo "== no CUDA Toolkit (nvcc isn't on the PATH): building for the CPU only"
  elif [ -z "$architecture" ] && [ "${MASU_CUDA:-AUTO}" != ON ]; then
    echo "== no GPU: building for the CPU only (MASU_CUDA=ON builds the CUDA backend, too)"
  else
    cuda_options=(-DMASU_CUDA=ON "-DMASU_CUDA_ARCHITECTURES=${architecture:-90}-real")
    echo "== CUDA Toolkit found ($(command -v nvcc)): building the CUDA backend for sm_${architecture:-90}"
  fi
}

# Shows a build's progress: on a terminal in one line, otherwise a line for each tenth, and for each half minute without
# progress.
show_progress() {
  local line count= shown=0 tenth begin=$SECONDS last=$SECONDS
  while true; do
    if IFS= read -r -t 5 line; then
      [[ $line =~ ^\[\ *([0-9]+)[/%] ]] || continue
      count=${line%%]*}]
      if [ -t 1 ]; then printf '\r\033[K%.*s' "$((${COLUMNS:-80} - 1))" "$line"; continue; fi
      [[ $line =~ ^\[([0-9]+)/([0-9]+) ]] && tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2])) || tenth=$((BASH_REMATCH[1] / 10))
      [ "$tenth" -gt "$shown" ] || continue
      shown=$tenth
    elif [ $? -gt 128 ]; then # no output for 5 s
      [ -t 1 ] || [ $((SECONDS - last)) -ge 30 ] || continue
      line="${count:+$count }still compiling"
    else
      break
    fi
    last=$SECONDS
    if [ -t 1 ]; then printf '\r\033[K%s, %d s' "$line" $((SECONDS - begin)); else echo "   $((SECONDS - begin)) s: $line"; fi
  done
  if [ -t 1 ]; then printf '\r\033[K'; fi
  echo "   done in $((SECONDS - begin)) s"
}

# build FOLDER [cmake option…] [-- build option…]: configures and builds. Of the environment MASU_STRICT is passed on, and
# MASU_CACHE, a file of settings that take precedence; what one left of them isn't kept for a build without.
build() {
  local folder=$1 configure=() log
  shift
  while [ $# -gt 0 ] && [ "$1" != -- ]; do configure+=("$1"); shift; done
  [ $# -gt 0 ] && shift
  if [ -n "${MASU_STRICT:-}" ]; then configure+=("-DMASU_STRICT=$MASU_STRICT"); fi
  if [ -n "${MASU_CACHE:-}" ]; then
    configure+=(-C "$MASU_CACHE")
  elif grep -qs '^MASU_BUILT_TO_CHECK:' "$folder/CMakeCache.txt"; then
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  fi
  if [ "$(uname -m)" = x86_64 ] && [ -r /proc/cpuinfo ] &&
      ! { grep -qw fma /proc/cpuinfo && grep -qw avx2 /proc/cpuinfo; }; then
    configure+=(-DMASU_AVX2=OFF)
  fi
  # Ninja compiles kernels and the libraries they are linked with at the same time.
  if command -v ninja >/dev/null && [ ! -e "$folder/CMakeCache.txt" ]; then configure+=(-G Ninja); fi
  log=$(mktemp)
  if ! { cmake -S . -B "$folder" "${configure[@]}" >"$log" 2>&1 &&
      { ! grep -q 'mesh2bin: off' "$log" || echo "== no Assimp (libassimp-dev): building without mesh2bin"; } &&
      { ! grep -q 'Tools for MPI: off' "$log" || echo "== no MPI (libopenmpi-dev): building without gridrender-mpi and gridtrace-mpi"; } &&
      { ! grep -q 'gridview: off' "$log" ||
        echo "== no cpp-httplib or libjpeg-turbo (libcpp-httplib-dev, libturbojpeg0-dev, pkg-config): building without gridview"; } &&
      { ! grep -q 'JPEG pictures: off' "$log" || echo "== no libjpeg-turbo (libturbojpeg0-dev, pkg-config): building without JPEG pictures"; } &&
      cmake --build "$folder" --parallel "$(nproc)" "$@" 2>&1 | tee "$log" | show_progress; }; then
    grep -E -A5 'error|Error|\*\*\*' "$log" || cat "$log"
    rm -f "$log"
    return 1
  fi
  rm -f "$log"
}
