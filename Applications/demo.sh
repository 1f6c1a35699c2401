#!/usr/bin/env bash
# Installs what is missing, builds, and pulls a leg of the dog long with one drawn line: pictures and mesh in demo/.
set -euo pipefail
. "$(dirname "$0")/setup.sh"
cd "$oversketch_root"
oversketch_install
oversketch_build release
mkdir -p demo
model=Data/Models/dog.ply stroke=Data/Strokes/dog_longer_leg.vtp
export PYTHONPATH=$oversketch_root/build/release/lib/python3/dist-packages
oversketch_display /usr/bin/python3 Testing/Pictures/draw.py $model $stroke demo/before.png
oversketch_display build/release/bin/oversketch one-stroke $model $stroke \
  -o demo/dog_longer_leg.ply --picture demo/after.png --report demo/report.json
echo "Before: $oversketch_root/demo/before.png"
echo "After:  $oversketch_root/demo/after.png"
echo "Mesh:   $oversketch_root/demo/dog_longer_leg.ply"
