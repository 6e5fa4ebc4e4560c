#!/usr/bin/env bash
# Fuzzes on many cores: run.sh FUZZ_BIN SEEDS SECONDS [JOBS [OUT]]. FUZZ_BIN holds the targets (and lib/, where they
# were built elsewhere), SEEDS what seeds.sh made, OUT gets logs, new inputs and, in found/, those that failed. Prints a
# table; 1 where something was found, other than by mesh_fuzz: most of that are Assimp's own faults.
set -euo pipefail
bin=$(realpath "$1") seeds=$(realpath "$2") seconds=$3 jobs=${4:-$(nproc)} here=$(realpath "$(dirname "$0")")
mkdir -p "${5:-fuzz_out}" && cd "${5:-fuzz_out}" && mkdir -p logs found
[ ! -d "$bin/lib" ] || export LD_LIBRARY_PATH=$bin/lib
# Cores, of 37; and inputs of a few times a seed's length. Choosing the library's calls by entropy takes longer than
# they do.
declare -A share=([nff]=6 [scene]=5 [grid]=5 [trace]=5 [list]=5 [library]=5 [mesh_file]=5 [mesh]=1)
declare -A options=([nff]=-max_len=4096 [scene]=-max_len=8192 [grid]=-max_len=20480 [trace]=-max_len=20480
  [list]=-max_len=1024 [library]="-max_len=1024 -entropic=0" [mesh_file]=-max_len=2048
  [mesh]=-max_len=4096)
# Leaks can't be searched for where processes may not be traced.
"$bin/nff_fuzz" -runs=1 -artifact_prefix=logs/ > logs/leaks.log 2>&1 || export ASAN_OPTIONS=detect_leaks=0

# TARGET NUMBER OPTION…: begins again after a failure, which ends the fuzzer.
work() {
  local target=$1 log=logs/$1-$2.log end=$((SECONDS + seconds)) failures=0
  shift 2
  [ ! -f "$here/$target.dict" ] || set -- "-dict=$here/$target.dict" "$@"
  while ((SECONDS < end && failures < 100)); do
    "$bin/${target}_fuzz" -max_total_time=$((end - SECONDS)) -print_final_stats=1 -timeout=30 -rss_limit_mb=4096 \
      "-artifact_prefix=found/$target-" "$@" >> "$log" 2>&1 || failures=$((failures + 1))
  done
}

targets=()
for target in nff scene grid trace list library mesh_file mesh; do
  [ ! -x "$bin/${target}_fuzz" ] || targets+=("$target")
done
all=0
for target in "${targets[@]}"; do all=$((all + share[$target])); done
for target in "${targets[@]}"; do
  mkdir -p "new/$target"
  workers=$(((jobs * share[$target] + all / 2) / all))
  for ((number = 1; number <= workers || number == 1; ++number)); do
    # shellcheck disable=SC2086
    work "$target" $number ${options[$target]} "new/$target" "$seeds/${target}_fuzz" &
  done
done
# The large seed is for one alone, which keeps what it finds in memory.
work grid large -max_len=20000000 -rss_limit_mb=16384 "-seed_inputs=$seeds/grid_fuzz/large" &
wait

echo "| target | executions | a second | edges covered | crashes | timeouts | out of memory | leaks |"
echo "|---|---|---|---|---|---|---|---|"
number_of() { find found -name "$1" | wc -l; }
bad=0
for target in "${targets[@]}"; do
  executions=$(cat logs/"$target"-*.log | awk '/^stat::number_of_executed_units/ { n += $2 } END { printf "%.0f", n }')
  edges=$(grep -oh 'cov: [0-9]*' logs/"$target"-*.log | awk '$2 > n { n = $2 } END { print n + 0 }')
  if [ "$executions" = 0 ] || { [ "$target" != mesh ] && [ "$(number_of "$target-[colt]*")" != 0 ]; }; then bad=1; fi
  echo "| \`$target\` | $executions | $((executions / seconds)) | $edges | $(number_of "$target-crash-*") |" \
    "$(number_of "$target-timeout-*") | $(number_of "$target-oom-*") | $(number_of "$target-leak-*") |"
done
exit $bad
