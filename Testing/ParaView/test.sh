#!/usr/bin/env bash
# Builds the ParaView plugin, getting ParaView first where it is not installed, and tests it: proxies against headers, pvpython,
# pvbatch, pvserver, state files, the meshes of the VTK build, a stroke drawn in the window, 200 models (20 for each commit) on 1, 2 and 4 ranks.
# Testing/test.sh paraview calls it. Arguments go to pytest. Where all of it has passed, tested.txt says of what sources (stamp.py).
set -euo pipefail
. "$(dirname "$0")/../../Applications/ParaView/setup.sh"
cd "$oversketch_root"
oversketch_paraview_build
if ! oversketch_has python3-paraview; then # else VTK's Python cannot be there
  oversketch_build release --target oversketch_python_stubs
  export OVERSKETCH_VTK_PACKAGE=$oversketch_root/build/release/lib/python3/dist-packages
fi

# run NAME ARGUMENT...: pytest with a display, and a bus for what a screen reader hears.
run() {
  XDG_CACHE_HOME=$oversketch_root/build/paraview/cache/$1 oversketch_in_paraview \
    xvfb-run -a -s '-screen 0 1280x1400x24 -noreset' dbus-run-session -- \
    /usr/bin/python3 -m pytest -q -s -p no:cacheprovider --basetemp="build/paraview/tests/$1" \
    --junitxml="build/paraview/Testing/times/$1.xml" "${@:2}"
}
mkdir -p build/paraview/tests
if [ $# -gt 0 ]; then
  run asked Testing/ParaView "$@"
  exit
fi
# Tests by hand, each in a window of ParaView, run beside all others: a hand waits more than it works.
hands=()
for of in dog fish; do
  run by_hand_$of -k $of Testing/ParaView/test_by_hand.py >build/paraview/by_hand_$of.log 2>&1 &
  hands+=($!)
done
code=0
run others --ignore=Testing/ParaView/test_by_hand.py Testing/ParaView || code=$?
for hand in "${hands[@]}"; do
  wait "$hand" || code=$?
done
cat build/paraview/by_hand_*.log
[ $code -eq 0 ] || exit $code
Testing/ParaView/stamp.py --write
