#!/usr/bin/env bash
# Measures every job beside its best peers and its limit, and prints one table.
# usage: run.sh [FOLDER]   (default build/benchmarks; results, table, picture go there). FOLDER/benchmarks.md of a run on a quiet
# machine is committed as RESULTS.md, benchmarks.png as cost.png.
# The bunnies come from OVERSKETCH_DATA, else ../shared/data beside the source tree. Wants a quiet machine and about half an hour.
set -euo pipefail
. "$(dirname "$0")/../../Applications/setup.sh"
folder=$(realpath -m "${1:-$oversketch_root/build/benchmarks}")
meshes=${OVERSKETCH_DATA:-$oversketch_root/../shared/data}/meshes
for file in bunny_5k.obj bunny_30k.ply bunny_180k.ply; do
  [ -f "$meshes/$file" ] || { echo "run.sh: no $meshes/$file; set OVERSKETCH_DATA to the folder of the data" >&2; exit 2; }
done
cd "$oversketch_root"
# Only measuring needs these: the fast BLAS for the peer CHOLMOD, pictures of curves, and Python packages to measure.
oversketch_packages+=(libopenblas0-pthread python3-matplotlib python3-venv)
oversketch_install
mkdir -p "$folder"
rm -rf "$folder"/*.json "$folder"/*.triplets "$folder"/*.plane "$folder/outlines"
echo "Commit $(git describe --always --dirty), $(date +%Y-%m-%d)." >"$folder/run.txt"
oversketch_build release --target benchmarks
# One hand of each outline of the acceptance run, for drawing_benchmark.
/usr/bin/python3 Testing/Acceptance/inflate/outlines.py "$folder/outlines"
find "$folder/outlines" -type f ! -name '*-1px-0.vtp' -delete
# measure PROGRAM NAME OPTION...: into NAME.json and NAME.log.
measure() {
  echo "Measuring: $2"
  OVERSKETCH_BENCHMARKS=$folder oversketch_display "$1" --data="$meshes" --benchmark_out="$folder/$2.json" \
    --benchmark_out_format=json "${@:3}" >"$folder/$2.log" 2>&1 || { tail -n 20 "$folder/$2.log" >&2; exit 1; }
}
for program in build/release/bin/*_benchmark; do
  name=$(basename "$program" _benchmark)
  if [[ $name == *memory ]]; then # a process for each size, or all would show the memory of the largest
    for size in 5k 30k 180k 1M; do
      measure "$program" "${name}_$size" --sizes=$size
    done
  else
    measure "$program" "$name"
  fi
done
echo "Measuring: Python peers"
environment=$(mktemp -d)
trap 'rm -rf "$environment"' EXIT
if /usr/bin/python3 -m venv "$environment" && "$environment/bin/pip" install -q numpy scipy libigl potpourri3d scikit-learn pymeshlab triangle; then
  "$environment/bin/python" Testing/Benchmarks/peers.py "$meshes" "$folder/peers.json" >"$folder/peers.log"
else
  echo "run.sh: the Python peers could not be installed; their columns stay empty" >&2
fi
/usr/bin/python3 Testing/Benchmarks/table.py "$folder"
echo "Table, JSON and picture: $folder"
