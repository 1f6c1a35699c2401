#!/usr/bin/env bash
# Prints the papers' tables beside ours, and Fig. 11's shares. FOLDER holds the three bunnies.
set -euo pipefail
. "$(dirname "$0")/../../Applications/setup.sh"
folder=${1:-${OVERSKETCH_DATA:-$oversketch_root/../shared/data}/meshes}
[ -f "$folder/bunny_5k.obj" ] || { echo "usage: $0 FOLDER (with bunny_5k.obj, bunny_30k.ply, bunny_180k.ply)" >&2; exit 2; }
oversketch_install
oversketch_build release --target oversketch_tables
echo "# Tables of the paper, its figures and ours"
echo
echo "Paper: Intel Core i7-3630QM, NVIDIA GeForce GT-650M, averages of 100 runs. Ours: $(grep -m1 'model name' /proc/cpuinfo |
  cut -d: -f2 | sed 's/^ *//'), $(nproc) cores, medians."
"$oversketch_root/build/release/bin/oversketch_tables" "$folder"
