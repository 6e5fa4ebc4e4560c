#!/bin/sh
# Writes a tool's man page, compressed: man.sh TOOL VERSION PAGE.gz.
set -e
help2man --no-info --no-discard-stderr --section=1 --version-string="$2" --source="Masu $2" --manual="Masu" \
  --name="$("$1" --help | sed '/^$/,$d' | tr '\n' ' ')" --output="${3%.gz}" "$1"
gzip -9nf "${3%.gz}"
