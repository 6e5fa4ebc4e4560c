# Sourced by demo.sh and test.sh: installs the Debian packages that are missing, and says whether CUDA is there.
# Sets cuda_options for cmake, and defines build().

install_missing() { # package…
  local missing=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "== installing ${missing[*]}"
  local root=()
  [ "$(id -u)" -eq 0 ] || root=(sudo)
  "${root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

install_missing build-essential cmake flatbuffers-compiler gnuplot-nox libflatbuffers-dev libcli11-dev libfmt-dev libgtest-dev \
  libpng-dev libtbb-dev libxxhash-dev nlohmann-json3-dev

# CUDA's own installer leaves nvcc off the PATH.
if ! command -v nvcc >/dev/null && [ -x /usr/local/cuda/bin/nvcc ] && [ "${MASU_CUDA:-AUTO}" != OFF ]; then
  PATH=$PATH:/usr/local/cuda/bin
fi
if [ "${MASU_CUDA:-AUTO}" != OFF ] && command -v nvcc >/dev/null; then
  # For the GPU that is here; where there is none, for one kind, to see that it compiles.
  architecture=$( (nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null || true) | head -n 1 | tr -d .)
  cuda_options=(-DMASU_CUDA=ON "-DMASU_CUDA_ARCHITECTURES=${architecture:-90}")
  echo "== CUDA Toolkit found ($(command -v nvcc)): building the CUDA backend for sm_${architecture:-90}"
else
  cuda_options=(-DMASU_CUDA=OFF)
  echo "== no CUDA Toolkit (nvcc isn't on the PATH), or MASU_CUDA=OFF: building for the CPU only"
fi

# build FOLDER [cmake option…] [-- build option…]: configures and builds, showing only what went wrong.
build() {
  local folder=$1 configure=() log
  shift
  while [ $# -gt 0 ] && [ "$1" != -- ]; do configure+=("$1"); shift; done
  [ $# -gt 0 ] && shift
  log=$(mktemp)
  if ! { cmake -S . -B "$folder" "${configure[@]}" && cmake --build "$folder" --parallel "$(nproc)" "$@"; } >"$log" 2>&1; then
    grep -E -A5 'error|Error|\*\*\*' "$log" || cat "$log"
    rm -f "$log"
    return 1
  fi
  rm -f "$log"
}
