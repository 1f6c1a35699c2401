#!/usr/bin/env bash
# Installs what is missing, builds, runs every test: the release build's, then the C++ tests again under the address
# and undefined-behaviour sanitizers.
set -euo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
cd "$oversketch_root"
oversketch_install
oversketch_build release
ctest --preset release -j2
oversketch_build asan
# Leaks are not counted: VTK, PoCL and Mesa keep memory until the process ends.
ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1 ctest --preset asan -j2
