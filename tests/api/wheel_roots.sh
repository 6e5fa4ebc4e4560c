#!/usr/bin/env bash
# Installs the module's wheel into the Python of other releases and runs its tests there: wheel_roots.sh WHEEL [RELEASE…],
# by default bookworm, trixie (Debian) and noble (Ubuntu). As root; debootstrap makes each release's root of its own in
# build/roots, and keeps it.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
wheel=$(realpath "$1")
shift
[ $# -gt 0 ] || set -- bookworm trixie noble
for release in "$@"; do
  root=$source/build/roots/$release
  if [ ! -e "$root/ready" ]; then
    rm -rf "$root"
    mkdir -p "$source/build/roots"
    mirror=(http://deb.debian.org/debian)
    # Debian has no keys of Ubuntu's: nothing of it leaves this root.
    [ "$release" = noble ] && mirror=(http://archive.ubuntu.com/ubuntu /usr/share/debootstrap/scripts/gutsy)
    options=(--variant=minbase --include=python3-numpy,python3-venv)
    [ "$release" = noble ] && options+=(--no-check-gpg --components=main,universe)
    debootstrap "${options[@]}" "$release" "$root" "${mirror[@]}" >"$source/build/roots/$release.log"
    touch "$root/ready"
  fi
  rm -rf "$root/wheel"
  mkdir "$root/wheel"
  cp "$wheel" "$source"/tests/api/python_*.py "$root/wheel"
  mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
  echo "== $release"
  chroot "$root" sh -ec "python3 --version; cd /wheel; python3 -m venv --system-site-packages venv
    venv/bin/pip install --no-index ./${wheel##*/}; venv/bin/python -c 'import masu; print(masu._library.library._name)'
    venv/bin/python -B python_test.py"
  umount "$root/proc"
done
