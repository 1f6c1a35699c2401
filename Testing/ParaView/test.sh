#!/usr/bin/env bash
# Builds the ParaView plugin, getting ParaView first where it is not installed, and tests it: proxies against headers, pvpython,
# pvbatch, pvserver, state files, 200 models on 1, 2 and 4 ranks. Testing/test.sh paraview calls it. Arguments go to pytest.
set -euo pipefail
. "$(dirname "$0")/../../Applications/ParaView/setup.sh"
cd "$oversketch_root"
oversketch_paraview_build
XDG_CACHE_HOME=$oversketch_root/build/paraview/cache oversketch_in_paraview \
  /usr/bin/python3 -m pytest -q -s -p no:cacheprovider --basetemp=build/paraview/tests Testing/ParaView/test_paraview.py "$@"
