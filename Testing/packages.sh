#!/usr/bin/env bash
# Builds the Debian packages in a root of this Debian release, installs them on a bare one, runs what they hold, takes them off.
#
# usage: Testing/packages.sh bookworm|trixie FOLDER      as root, with a network
#
# FOLDER keeps the roots and the compiler's cache, so that another run is short; delete it afterwards.
set -euo pipefail
if [ $# -ne 2 ] || [ "$(id -u)" -ne 0 ]; then
  sed -n '2,6s/^# \?//p' "$0" >&2
  exit 2
fi
release=$1
. "$(dirname "$0")/../Applications/setup.sh"
oversketch_install mmdebstrap
mkdir -p "$2"
folder=$(cd "$2" && pwd)/$release
mkdir -p "$folder/ccache"

# in_root ROOT COMMAND: runs it in the root, with proc, sys, dev and a terminal's folder for as long as it takes.
in_root() {
  cp /etc/resolv.conf "$1/etc/resolv.conf"
  mkdir -p "$1/ccache"
  unshare --mount --fork sh -ec '
    mount --bind /proc "$1/proc"; mount --bind /sys "$1/sys"; mount --rbind /dev "$1/dev"
    mount --bind "$2" "$1/ccache"
    exec chroot "$1" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive CCACHE_DIR=/ccache sh -ec "$3"' sh "$1" "$folder/ccache" "$2"
}

# The bare system, once as it is and once with what the build needs.
if [ ! -e "$folder/bare.tar" ]; then
  mmdebstrap --quiet --format=tar --variant=apt "$release" "$folder/bare.tar.part"
  mv "$folder/bare.tar.part" "$folder/bare.tar"
fi
build=$folder/build
if [ ! -e "$build" ]; then
  mkdir "$build"
  tar -C "$build" -xf "$folder/bare.tar"
fi
in_root "$build" "apt-get update -qq
  apt-get install -y -qq --no-install-recommends dpkg-dev file lintian ${oversketch_packages[*]} >/dev/null"

# The packages.
rm -rf "$build/source" "$folder/debs"
mkdir -p "$build/source" "$folder/debs"
git -C "$oversketch_root" ls-files -z | tar -C "$oversketch_root" --null -T - -c | tar -C "$build/source" -x
in_root "$build" "cd /source
  cmake --preset package >/source/package.log 2>&1 && cmake --build --preset package -j2 >>/source/package.log 2>&1 &&
    cd build/package && cpack >>/source/package.log 2>&1 || { tail -n 40 /source/package.log >&2; exit 1; }
  lintian --allow-root --fail-on error --suppress-tags package-name-doesnt-match-sonames *.deb"
cp "$build"/source/build/package/*.deb "$folder/debs"

# What the build itself makes of the shipped files, on the processor: the bare system has no OpenCL device.
in_root "$build" 'cd /source
  OVERSKETCH_OPENCL=off PYTHONPATH=build/package/lib/python3/dist-packages \
    python3 Testing/Packages/results.py README.md Data build/package/bin/oversketch >results.txt'

# A bare system: installed, run, taken off.
bare=$folder/bare
rm -rf "$bare"
mkdir "$bare"
tar -C "$bare" -xf "$folder/bare.tar"
mkdir "$bare/trial"
cp "$folder"/debs/*.deb "$bare/trial"
cp -r "$oversketch_root/Testing/Consumer" "$bare/trial/consumer"
cp "$oversketch_root"/{README.md,Testing/{Packages/{installed_studio,results},ParaView/digest,Studio/desk}.py} "$bare/trial"
cp "$build/source/results.txt" "$bare/trial/build.txt"
in_root "$bare" 'cd /trial
  apt-get update -qq
  apt-get install -y -qq ./*.deb >apt.log 2>&1 || { tail -n 40 apt.log >&2; exit 1; }
  echo "installed: $(dpkg-query -W -f="\${Package} \${Version} " "*oversketch*")"'
in_root "$bare" '
  data=/usr/share/oversketch
  oversketch --version
  python3 -c "import oversketch; print(\"python:\", oversketch.__version__)"
  cd /trial
  OVERSKETCH_OPENCL=off python3 results.py README.md $data /usr/bin/oversketch >results.txt
  diff build.txt results.txt
  count=$(grep -c "[0-9a-f]\{32\}" results.txt)
  test "$count" -ge 9
  echo "README: $count results, the bits of the build"
  grep -q "application/x-oversketch-session:\*.oversketch" /usr/share/mime/globs2 && echo "file type: known"'
# What the tests themselves need comes only now: the packages have run without it.
in_root "$bare" 'cd /trial
  apt-get install -y -qq --no-install-recommends g++ cmake ninja-build xvfb xauth python3-xlib >>apt.log 2>&1
  cmake -G Ninja -S consumer -B consumer/build -DCMAKE_BUILD_TYPE=Release >consumer.log 2>&1 &&
    cmake --build consumer/build >>consumer.log 2>&1 || { cat consumer.log >&2; exit 1; }
  data=/usr/share/oversketch
  echo "consumer: $(xvfb-run -a consumer/build/consumer $data/Models/dog.ply $data/Strokes/dog_longer_leg.vtp consumer.png) (points moved, furthest)"
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" python3 installed_studio.py studio.png'
cp "$bare/trial/consumer.png" "$folder/consumer.png"
cp "$bare/trial/studio.png" "$folder/studio.png"
in_root "$bare" 'rm -rf /trial /root/.cache /root/.config /root/.local
  apt-get purge -y -qq oversketch python3-oversketch liboversketch-dev liboversketch >/dev/null
  left=$(find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /ccache -o -path /var/cache -o -path /var/log -o -path /tmp \) -prune -o -iname "*oversketch*" -print)
  test -z "$left" || { echo "left behind: $left" >&2; exit 1; }
  ! grep -rq oversketch /usr/share/mime/globs2 /usr/share/mime/packages /var/lib/dpkg/status /var/lib/dpkg/triggers /etc 2>/dev/null ||
    { echo "still known: $(grep -rl oversketch /usr/share/mime /var/lib/dpkg/status /etc)" >&2; exit 1; }
  echo "purged: nothing is left"'
echo "$release: all of it; pictures in $folder"
