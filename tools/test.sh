#!/usr/bin/env bash
# Installs missing packages, builds (with CUDA where there are a toolkit and a GPU), and runs all tests. Its last line
# counts those that were skipped, and of them those that need a GPU. test.sh --full also runs those labelled slow, which
# need 6 GB of memory and of disk.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/setup.sh
require "${basics[@]}" libgtest-dev -- "${tests[@]}" "${extras[@]}"
find_cuda

echo "== building programs and tests: some nine minutes on two cores, with CUDA seven more"
build build -DCMAKE_BUILD_TYPE=Release -DMASU_TESTS=ON "${cuda_options[@]}"

echo "== tests"
# In memory where there is room: they write and read thousands of files.
room=$(df --output=avail -B 1G /dev/shm 2>/dev/null | tail -n 1 || true)
if [ -z "${TMPDIR:-}" ] && [ -w /dev/shm ] && [ "${room:-0}" -ge 2 ]; then export TMPDIR=/dev/shm; fi
# Large arrays in large pages: on virtual machines the first writes to small ones take long.
export GLIBC_TUNABLES=${GLIBC_TUNABLES:-glibc.malloc.hugetlb=1}
slow=()
[ "${1:-}" = --full ] && slow=(-C slow)
status=0
cores=$(nproc)
# More at once than there are cores: many wait for others, for pipes and for signals.
ctest --test-dir build --output-on-failure --parallel $((cores + cores / 2 + 1)) --output-junit tests.xml "${slow[@]}" ||
  status=$?
awk 'BEGIN { RS = "<testcase " }
  NR > 1 && /status="run"/ { passed++ }
  NR > 1 && /status="fail"/ { failed++ }
  NR > 1 && /status="notrun"/ { skipped++; if (/GPU|CUDA/) gpu++ }
  END { printf "== %d tests passed, %d failed, %d were skipped, %d of them for want of a GPU\n", passed, failed, skipped, gpu }' \
  build/tests.xml
exit $status
