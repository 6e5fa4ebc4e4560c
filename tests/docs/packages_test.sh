#!/usr/bin/env bash
# What Debian packages hold, and what lintian says of them where it is installed: packages_test.sh FOLDER.
set -euo pipefail
cd "$1"
control=$(mktemp -d)
trap 'rm -rf "$control"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

holds() { # package, file…
  local package=$1 file listed
  shift
  listed=$(dpkg-deb --contents "${package}"_*.deb)
  for file in "$@"; do grep -qF " ./usr/$file" <<<"$listed" || fail "$package has no $file"; done
}
holds masu bin/gridrender bin/gridtrace share/man/man1/gridtrace.1.gz share/doc/masu/README.md share/doc/masu/examples/lesson.sh
holds libmasu0 lib/libmasu.so.0
holds libmasu-dev lib/libmasu.so lib/pkgconfig/masu.pc lib/cmake/masu/masuConfig.cmake include/masu/masu.hpp \
  share/doc/libmasu-dev/examples/depth.c
holds python3-masu lib/python3/dist-packages/masu/__init__.py share/doc/python3-masu/examples/lidar.py

for file in *.deb; do
  package=${file%%_*}
  holds "$package" "share/doc/$package/changelog.gz" "share/doc/$package/copyright"
  dpkg-deb --contents "$file" | grep -E 'man1/[^/]*[^z]$' && fail "$package has an uncompressed man page"
  dpkg-deb --fsys-tarfile "$file" | tar -xO "./usr/share/doc/$package/changelog.gz" | gzip -d | grep -q "^masu (" ||
    fail "$package: changelog.gz"
done
dpkg-deb --control libmasu0_*.deb "$control"
[ "$(cat "$control/triggers")" = "activate-noawait ldconfig" ] || fail "libmasu0 has no trigger"

if command -v lintian >/dev/null; then
  lintian --fail-on error,warning --allow-root ./*.deb
else
  echo "left out: lintian isn't installed"
fi
