#!/usr/bin/env bash
# Builds the ParaView plugin, getting ParaView first where it is not installed, and tests it: proxies against headers, pvpython,
# pvbatch, pvserver, state files, the meshes of the VTK build, a stroke drawn in the window, 200 models on 1, 2 and 4 ranks.
# Testing/test.sh paraview calls it. Arguments go to pytest. Where all of it has passed, tested.txt says of what sources (stamp.py).
set -euo pipefail
. "$(dirname "$0")/../../Applications/ParaView/setup.sh"
cd "$oversketch_root"
oversketch_paraview_build
if ! oversketch_has python3-paraview; then # else VTK's Python cannot be there
  oversketch_build release --target oversketch_python_stubs
  export OVERSKETCH_VTK_PACKAGE=$oversketch_root/build/release/lib/python3/dist-packages
fi
# A display and a bus for what a screen reader hears, for the tests of ParaView's window.
XDG_CACHE_HOME=$oversketch_root/build/paraview/cache oversketch_in_paraview \
  xvfb-run -a -s '-screen 0 1280x1400x24 -noreset' dbus-run-session -- \
  /usr/bin/python3 -m pytest -q -s -p no:cacheprovider --basetemp=build/paraview/tests \
  --junitxml=build/paraview/Testing/times/paraview.xml Testing/ParaView "$@"
if [ $# -eq 0 ]; then
  Testing/ParaView/stamp.py --write
fi
