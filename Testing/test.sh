#!/usr/bin/env bash
# Installs what is missing, builds, and runs what must hold for each commit, each test in its one home: kernels, files and what is hostile
# under the address and undefined-behaviour sanitizers, all else in the release build.
#
# usage: Testing/test.sh          all that
#        Testing/test.sh full     everything there is, hours; begun again where it stopped
#        Testing/test.sh PART...  parts by name; Testing/test.sh list names them. paraview: the ParaView plugin, paraview-changed:
#                                 the same where its sources are not those that were tested last (ParaView/stamp.py)
set -euo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
cd "$oversketch_root"
if [ "${1:-}" = paraview-changed ]; then
  if Testing/ParaView/stamp.py; then
    echo "The ParaView plugin is what was tested last."
    exit
  fi
  set -- paraview
fi
if [ "$*" != paraview ]; then # which may need other packages
  oversketch_install
  oversketch_install chromium # of the page's tests
fi
exec /usr/bin/python3 Testing/suite.py "$@"
