# Sourced by Applications/demo.sh and Testing/test.sh: installs what is missing, configures and builds a preset.
# Debian 12 and 13. Everything comes from Debian's own packages; nothing is downloaded at configure time.

oversketch_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

oversketch_packages=(
  g++ cmake ninja-build ccache mold
  libvtk9-dev libvtk9-qt-dev qtbase5-dev python3-vtk9 python3-numpy libeigen3-dev libboost-dev libcgal-dev libembree-dev
  libopencv-core-dev libopencv-imgproc-dev libopencv-photo-dev libgdal-dev
  ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd libsuitesparse-dev libtbb-dev
  libarchive-dev libexpat1-dev libgtest-dev libbenchmark-dev python3-dev python3-pytest python3-pip python3-venv python3-matplotlib mypy
  python3-xlib xvfb xauth libgl1-mesa-dri doxygen at-spi2-core dbus-daemon gir1.2-atspi-2.0 python3-gi
  dpkg-dev file)
oversketch_debian=$(. /etc/os-release && echo "${VERSION_ID:-13}") # testing has none
if [ "$oversketch_debian" -ge 13 ]; then # with them the tests of the wheel and of PyVista need no package index
  oversketch_packages+=(python3-scikit-build-core python3-pyvista)
fi

# oversketch_has PACKAGE: whether it is installed.
oversketch_has() {
  dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'ok installed'
}

# oversketch_install [PACKAGE...]: installs those of them, or of all, that are not there, as root; asks for root once, says what it
# installs, is quiet otherwise.
oversketch_install() {
  local missing=() package
  [ $# -gt 0 ] || set -- "${oversketch_packages[@]}"
  for package in "$@"; do
    oversketch_has "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  if oversketch_has python3-paraview && [[ " ${missing[*]} " = *" python3-vtk9 "* ]]; then
    echo "oversketch: python3-vtk9 would replace the installed python3-paraview, which owns the same files; remove that first" >&2
    return 1
  fi
  echo "Installing Debian packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "oversketch: these packages need root, and there is no sudo" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" sh -c 'apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@"' \
    sh "${missing[@]}" >/dev/null || { echo "oversketch: could not install ${missing[*]}" >&2; return 1; }
}

# oversketch_build PRESET [OPTION...]: configures and builds; one line counts the steps, the log is shown when it fails. The options
# go to cmake --build. The caller has pipefail set.
oversketch_build() {
  local preset=$1 log
  shift
  log=$oversketch_root/build/$preset.log
  mkdir -p "$oversketch_root/build"
  echo "Building preset $preset${*:+ $*} (log: build/$preset.log)"
  (cd "$oversketch_root" && cmake --preset "$preset" && NINJA_STATUS='[%f/%t] ' cmake --build --preset "$preset" "$@") 2>&1 |
    tee "$log" | oversketch_count ||
    { tail -n 60 "$log" >&2; echo "oversketch: the build failed" >&2; return 1; }
}

# Reads Ninja's output and says how far it is: on a terminal in one line that is written over, else a line for each tenth.
oversketch_count() {
  local terminal=0
  [ -t 1 ] && terminal=1
  awk -F '[][/]' -v terminal=$terminal '
    /^\[[0-9]+\/[0-9]+\] / {
      if (terminal) printf "\r  %d of %d", $2, $3
      else if (int(10 * $2 / $3) > tenth) { tenth = int(10 * $2 / $3); printf "  %d of %d\n", $2, $3 }
      fflush()
    }
    END { if (terminal) print "" }'
}

# oversketch_display COMMAND...: runs it, on a virtual display where there is none.
oversketch_display() {
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
  else
    xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' "$@"
  fi
}
