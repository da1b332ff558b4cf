#!/bin/sh
# Fails when libspe2.h declares a function, type or constant that the real library's header does not, or misses one: a
# program written with ours would not build on a Cell. Values and sizes are coverage.sh's.
#
# Usage: libspe2_interface.sh COMPILER INCLUDE_DIR SDK_NAMES.tsv
set -eu
compiler=$1
include_dir=$2
names=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -F '\t' '$1 ~ /^libspe2\.h/ { print $2 }' "$names" | sort >"$work/wanted"

# What the two headers themselves say, without what they include: declarations one a line, then macros.
echo '#include <libspe2.h>' | $compiler -E -x c -I"$include_dir" - |
  awk '/^# [0-9]/ { ours = $3 ~ /libspe2(-types)?\.h"$/; next } ours' >"$work/text"
{
  grep -oE '\bspe_[a-z0-9_]+ *\(' "$work/text" | tr -d ' ('
  tr '\n' ' ' <"$work/text" | grep -oE '(\}|typedef [^{};]*[ *])[ ]*spe_[a-z0-9_]+_t *;' | grep -oE 'spe_[a-z0-9_]+_t *;' | tr -d ' ;'
  grep -oE '\bSPE_[A-Z0-9_]+\b' "$work/text"
  sed -nE 's/^ *# *define +((SPE_|SIG)[A-Z0-9_]+) .*/\1/p' "$include_dir/libspe2.h" "$include_dir/libspe2-types.h"
} | sort -u >"$work/declared"

if ! diff "$work/wanted" "$work/declared" >"$work/difference"; then
  echo "libspe2.h differs from the real one (< missing, > not there):"
  grep '^[<>]' "$work/difference"
  exit 1
fi
echo "$(wc -l <"$work/wanted") names, as the real libspe2.h has them"
