#!/usr/bin/env bash
# Runs the OpenCL kernels' tests of a build under Oclgrind, a device that checks every access: memory outside a buffer,
# races between work-items, wrong calls. It interprets. Debian has it; it is installed where it is missing.
#
# usage: Testing/oclgrind.sh [BUILD]      default build/release
set -euo pipefail
. "$(dirname "$0")/../Applications/setup.sh"
build=$(realpath "${1:-$oversketch_root/build/release}")
oversketch_install
oversketch_install oclgrind
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

failed=0
# run PROGRAM FILTER: the tests of that program that run kernels.
run() {
  local log=$work/$1.log
  cmake --build "$build" --target "$1"
  echo "oclgrind: $1 $2"
  oclgrind --data-races --check-api --max-errors 20 --log "$log" "$build/bin/$1" --gtest_brief=1 --gtest_filter="$2" ||
    { echo "oclgrind: $1 failed" >&2; failed=1; }
  if [ -s "$log" ]; then
    cat "$log" >&2
    failed=1
  fi
}
run kernel_opencl_test 'Device.RunsAnEmbeddedProgram:Device.BuildsAProgramOnce*'
run kernel_mixture_test 'A7_4.DeviceReduction*:Mixture.DeviceFit*'
run kernel_ray_test 'Ray.BothBackends*'
run filters_silhouette_test '*TheDeviceDecidesLikeTheHost'
exit $failed
