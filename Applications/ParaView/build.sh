#!/usr/bin/env bash
# Builds the ParaView plugin, getting ParaView first where it is not installed, and says how to start ParaView with it. With
# arguments, runs them with that ParaView and the plugin: build.sh paraview, build.sh pvpython script.py, build.sh mpirun ...
set -euo pipefail
. "$(dirname "$0")/setup.sh"
oversketch_paraview_build
if [ $# -gt 0 ]; then
  oversketch_in_paraview "$@"
else
  echo "Plugin: $(find "$oversketch_root/build/paraview/lib" -name Oversketch.so)"
  echo "ParaView with it: Applications/ParaView/build.sh paraview"
fi
