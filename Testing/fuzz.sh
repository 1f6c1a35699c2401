#!/usr/bin/env bash
# Coverage-guided fuzzing (libFuzzer of Debian's clang, address and undefined-behaviour sanitizers) of what comes from outside: every mesh
# reader, strokes, pictures, heights, files of parts, sessions, and the whole of systems A and D on tiny meshes and of system C. Fails where
# an input crashes, is neither refused nor sound, takes more than 20 s or 2 GiB. Such an input is left in build/fuzz/found; once it is mended
# it belongs into Testing/Fuzz/Corpora/TARGET, which the test fuzz_corpus_test replays. What else it finds new is kept in build/fuzz/corpora,
# where the next run begins.
#
# usage: Testing/fuzz.sh [INPUTS|SECONDSs [TARGET...]]   10000 for each target, or 600s shared out over them; one_stroke, augment and drawing, which take some hundred times as long, a hundredth
set -euo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
cd "$oversketch_root"
inputs=${1:-10000}
shift || true
targets=("$@")
seconds=
if [[ $inputs = *s ]]; then
  seconds=${inputs%s} inputs=0
fi
[ ${#targets[@]} -gt 0 ] || targets=(ply obj off stl gltf glb vtp stroke picture heights parts session session_text one_stroke augment drawing)
oversketch_install
oversketch_install clang
oversketch_install "libclang-rt-$(clang -dumpversion | cut -d. -f1)-dev"
oversketch_build fuzz --target fuzz
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
folder=$oversketch_root/build/fuzz
shards=$(nproc)
mkdir -p "$folder/found" "$folder/logs"

failed=0
for target in "${targets[@]}"; do
  seeds=$oversketch_root/Testing/Fuzz/Corpora/$target
  [ -d "$seeds" ] || { echo "fuzz.sh: there is no target $target" >&2; exit 2; }
  mkdir -p "$folder/corpora/$target"
  count=$inputs
  case $target in one_stroke | augment | drawing) count=$((inputs / 100 + 1)) ;; esac
  limit=-runs=$((count / shards + 1))
  [ -z "$seconds" ] || limit=-max_total_time=$((seconds / ${#targets[@]} + 1))
  start=$SECONDS
  running=()
  for ((shard = 0; shard < shards; ++shard)); do
    OVERSKETCH_FUZZ=$target "$folder/bin/fuzz" "$limit" -max_len=20000 -timeout=20 -rss_limit_mb=2048 \
      -malloc_limit_mb=2048 -print_final_stats=1 "-artifact_prefix=$folder/found/$target-" "$folder/corpora/$target" "$seeds" \
      > "$folder/logs/$target.$shard.log" 2>&1 &
    running+=($!)
  done
  codes=()
  for process in "${running[@]}"; do
    rc=0
    wait "$process" || rc=$?
    codes+=("$rc")
    [ "$rc" -eq 0 ] || failed=1
  done
  run=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/logs/$target".*.log | awk "{ sum += \$1 } END { print sum }")
  peak=$(sed -n 's/^stat::peak_rss_mb: *//p' "$folder/logs/$target".*.log | sort -n | tail -n 1)
  echo "$target: ${run:-0} inputs, $((SECONDS - start)) s, at most ${peak:-?} MB, exit ${codes[*]}"
  for ((shard = 0; shard < shards; ++shard)); do
    [ "${codes[shard]}" -eq 0 ] || tail -n 40 "$folder/logs/$target.$shard.log"
  done
done
exit "$failed"
