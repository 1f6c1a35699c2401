#!/usr/bin/env bash
# Installs what is missing, builds, and tests, each test in its one home: what draws and what Python runs in the release build, all
# other C++ tests under the address and undefined-behaviour sanitizers.
#
# usage: Testing/test.sh          all that
#        Testing/test.sh tsan     the C++ tests under the thread sanitizer, alone
#        Testing/test.sh paraview the ParaView plugin, alone; gets ParaView where it is not installed
set -euo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
cd "$oversketch_root"
if [ "${1:-}" = paraview ]; then
  exec Testing/ParaView/test.sh "${@:2}"
fi
oversketch_install
if [ "${1:-}" = tsan ]; then
  oversketch_build tsan --target tests
  # VTK's own threads: TBB's locks are in a library that the sanitizer does not see into.
  VTK_SMP_BACKEND_IN_USE=STDThread TSAN_OPTIONS="suppressions=$oversketch_root/Testing/tsan.supp" ctest --preset tsan -L home
  exit
fi
oversketch_build release --target all tests
ctest --preset release -L home -j2
oversketch_build asan --target tests # the command and the Studio are run by Python, which it cannot judge
# Leaks are not counted: VTK, PoCL and Mesa keep memory until the process ends. No stack for signals: LLVM puts its own into
# threads in which it compiles, and the sanitizer would end the process over it.
ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:use_sigaltstack=0 UBSAN_OPTIONS=print_stacktrace=1 ctest --preset asan -L home -j2
