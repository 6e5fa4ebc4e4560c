#!/usr/bin/env bash
# For developers: tsan_tbb.sh FOLDER builds this system's version of oneTBB for ThreadSanitizer and installs it into
# FOLDER; an instrumented TBB shows how it orders tasks. The source is the distribution's (apt-get source; nothing is
# installed elsewhere).
set -euo pipefail
[ $# -eq 1 ] || { sed -nE '2,4s/^# ?//p' "$0" >&2; exit 1; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
version=$(dpkg-query -f '${source:Upstream-Version}' -W libtbb-dev)
if [ -e "$folder/version" ] && [ "$(cat "$folder/version")" = "$version" ]; then exit 0; fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# This system's sources of packages, asked for source packages.
mkdir -p lists/partial parts cache/archives/partial
for file in /etc/apt/sources.list.d/*.sources; do
  [ ! -e "$file" ] || sed -E 's/^Types:.*/Types: deb-src/' "$file" > "parts/$(basename "$file")"
done
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ ! -e "$file" ] || sed -nE 's/^deb /deb-src /p' "$file" >> parts/all.list
done
apt=(-o "Dir::Etc::sourcelist=/dev/null" -o "Dir::Etc::sourceparts=$work/parts" -o "Dir::State::lists=$work/lists"
  -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root -qq)
apt-get "${apt[@]}" update
apt-get "${apt[@]}" source --download-only onetbb
mkdir source
tar -x -f onetbb_*.orig.tar.* -C source --strip-components 1
cmake -S source -B build -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_SANITIZE=thread -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF \
  -DTBB_STRICT=OFF "-DCMAKE_INSTALL_PREFIX=$folder" -DCMAKE_INSTALL_LIBDIR=lib > cmake.log || { cat cmake.log; exit 1; }
cmake --build build -j "$(nproc)" --target install > build.log 2>&1 || { cat build.log; exit 1; }
echo "$version" > "$folder/version"
