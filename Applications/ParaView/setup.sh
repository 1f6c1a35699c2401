# Sourced by build.sh and Testing/ParaView/test.sh: finds ParaView, or unpacks Debian's beside the installed VTK, and builds the
# plugin against it. Debian 12 (ParaView 5.11) and 13 (5.13).

. "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"

# What ParaView's CMake package asks for besides what the set-up of Oversketch installs.
if [ "$oversketch_debian" -ge 13 ]; then # ParaView 5.13 is built with Qt 6
  oversketch_packages+=(qt6-base-dev qt6-svg-dev qt6-svg-plugins qt6-tools-dev qt6-5compat-dev) # the plugins: ParaView's icons
else
  oversketch_packages+=(libqt5svg5-dev libqt5x11extras5-dev qttools5-dev libqt5xmlpatterns5-dev qtxmlpatterns5-dev-tools)
fi
oversketch_packages+=(mpi-default-bin mpi-default-dev)

# Sets oversketch_paraview to the prefix of ParaView: /usr where it is installed and its CMake package is whole (not so on Debian 13),
# else build/paraview-root/usr, where Debian's three packages are unpacked: python3-paraview and python3-vtk9 own the same files, so
# the machine cannot have both installed. What they depend on is installed.
oversketch_paraview_find() {
  local package others=()
  if oversketch_has python3-paraview; then
    for package in "${oversketch_packages[@]}"; do # VTK's Python would take its place
      case $package in python3-vtk9 | python3-pyvista) ;; *) others+=("$package") ;; esac
    done
    oversketch_packages=("${others[@]}")
    if [ -e /usr/lib/python3/dist-packages/vtkmodules/vtkCommonCore.so ] && oversketch_has paraview-dev; then
      oversketch_paraview=/usr
      oversketch_install
      return
    fi
  fi
  local root=$oversketch_root/build/paraview-root
  oversketch_paraview=$root/usr
  if [ ! -x "$root/usr/bin/pvpython" ]; then
    oversketch_install # its lists of packages are what apt-get download reads
    echo "Unpacking Debian's ParaView into build/paraview-root"
    rm -rf "$root" "$root.new"
    mkdir -p "$root.new/packages"
    (cd "$root.new/packages" && apt-get download -qq paraview paraview-dev python3-paraview) 2>"$root.new/download" ||
      { cat "$root.new/download" >&2
        echo "oversketch: apt-get could not download paraview; its lists of packages may be old: apt-get update" >&2; return 1; }
    for package in "$root.new"/packages/*.deb; do
      dpkg-deb -f "$package" Depends >>"$root.new/depends"
      dpkg -x "$package" "$root.new"
    done
    # Debian 13 names Python's libraries otherwise than the CMake package does, which then refuses to be found.
    find "$root.new/usr/lib/python3" -name '*.cpython-*.so' -exec sh -c 'ln -s "$(basename "$1")" "${1%.cpython-*}.so"' sh {} \;
    rm -r "$root.new/packages"
    mv "$root.new" "$root"
  fi
  # The first of each choice, without versions, without the three themselves and what is no package (tclsh).
  mapfile -t -O ${#oversketch_packages[@]} oversketch_packages < <(tr ',' '\n' <"$root/depends" |
    sed -E 's/[|(].*//; s/:any//; s/ //g' | grep -vE '^(paraview|tclsh|)$' | sort -u)
  oversketch_install
}

# oversketch_in_paraview COMMAND...: with ParaView's programs, libraries and Python before the system's, and the plugin's.
oversketch_in_paraview() {
  local plugin
  plugin=$(find "$oversketch_root/build/paraview/lib" -name Oversketch.so)
  env PATH="$oversketch_paraview/bin:$PATH" \
    LD_LIBRARY_PATH="$oversketch_paraview/lib/$(g++ -print-multiarch)${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" \
    PYTHONPATH="$oversketch_root/build/paraview/lib/python3/dist-packages:$oversketch_paraview/lib/python3/dist-packages" \
    OVERSKETCH_PLUGIN="$plugin" "$@"
}

# Builds the plugin into build/paraview.
oversketch_paraview_build() {
  oversketch_paraview_find
  local multiarch
  multiarch=$(g++ -print-multiarch)
  # What runs while the plugin is built, ParaView's own tools and the maker of Python's type stubs, needs its libraries and Python.
  (
    export CMAKE_PREFIX_PATH=$oversketch_paraview
    export LD_LIBRARY_PATH=$oversketch_paraview/lib/$multiarch${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
    export PYTHONPATH=$oversketch_paraview/lib/python3/dist-packages
    oversketch_build paraview "$@"
  )
}
