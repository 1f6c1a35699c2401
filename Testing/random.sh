#!/usr/bin/env bash
# Random sequences of 200 events on each widget and on the Studio's window, under the address and undefined-behaviour
# sanitizers, shared out over the cores: no crash, no error, memory level. Fails where one does. The usual tests run
# few of them; this runs as many as asked for. A sequence is made of its number: OVERSKETCH_SEQUENCES=1 and
# OVERSKETCH_FIRST_SEQUENCE=NUMBER see one again.
#
# usage: Testing/random.sh [SEQUENCES [PART...]]   1000 on each part; parts: camera style stroke drawing one_stroke
#        augment edit window canvas (the window with a drawing of two parts)
set -euo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
cd "$oversketch_root"
sequences=${1:-1000}
shift || true
parts=${*:-camera style stroke drawing one_stroke augment edit window canvas}
oversketch_install
oversketch_build asan-full --target widgets_camera_test widgets_style_test widgets_stroke_test widgets_drawing_test widgets_one_stroke_test widgets_augment_test widgets_edit_test studio_window_test
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:use_sigaltstack=0 UBSAN_OPTIONS=print_stacktrace=1
export OVERSKETCH_OPENCL=off LP_NUM_THREADS=0 # the cores are the shards'
logs=build/asan-full/Testing/Temporary/random
mkdir -p "$logs"
shards=$(nproc)
if [ "$shards" -gt "$sequences" ]; then
  shards=$sequences
fi

# Runs some sequences on a display of its own; how it went is the last line of the log.
shard() {
  local part=$1 number=$2 first=$3 count=$4 program=widgets_$1_test filter='Random.*' rc=0
  if [ "$part" = window ]; then
    program=studio_window_test filter=Window.LivesThroughRandomHands
  elif [ "$part" = canvas ]; then
    program=studio_window_test filter=Window.LivesThroughRandomHandsOnADrawing
  fi
  OVERSKETCH_FIRST_SEQUENCE=$first OVERSKETCH_SEQUENCES=$count \
    xvfb-run -a -n $((200 + 50 * number)) -s '-screen 0 1280x1024x24 -noreset' \
    "build/asan-full/bin/$program" "--gtest_filter=$filter" > "$logs/$part.$number.log" 2>&1 || rc=$?
  return "$rc"
}

failed=0
for part in $parts; do
  start=$SECONDS
  running=()
  for ((number = 0; number < shards; ++number)); do
    first=$((sequences * number / shards))
    shard "$part" "$number" "$first" $((sequences * (number + 1) / shards - first)) &
    running+=($!)
  done
  codes=()
  for ((number = 0; number < shards; ++number)); do
    rc=0
    wait "${running[number]}" || rc=$?
    codes+=("$rc")
  done
  echo "$part: $sequences sequences, $((200 * sequences)) events, $((SECONDS - start)) s, exit ${codes[*]}"
  for ((number = 0; number < shards; ++number)); do
    log=$logs/$part.$number.log
    grep 'of 200 events' "$log" | sed 's/^/  /' || true
    if [ "${codes[number]}" -ne 0 ]; then
      failed=1
      echo "  failed: $log"
      tail -n 40 "$log"
    fi
  done
done
exit "$failed"
