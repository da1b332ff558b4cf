#!/bin/sh
# Fails when the library cannot become part of a shared one, or when that shows anything but the functions of libspe2.h
# and what spu_emu/emulation.h and spu_emu/cycles.h declare.
#
# Usage: shared_library.sh COMPILER LIBRARY INCLUDE_DIR SDK_NAMES.tsv
set -eu
compiler=$1
library=$2
include_dir=$3
names=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

$compiler -shared -o "$work/shared.so" -Wl,--whole-archive "$library" -Wl,--no-whole-archive
# Weak symbols are the standard library's templates.
nm -DC --defined-only "$work/shared.so" | awk '$2 ~ /^[TDBR]$/ { sub(/^[^ ]+ . /, ""); print }' >"$work/shown"

awk -F '\t' '$1 == "libspe2.h" { print $2 }' "$names" | sort >"$work/wanted"
grep -v '^spu_emu::' "$work/shown" | sort >"$work/functions"
if ! diff "$work/wanted" "$work/functions" >"$work/difference"; then
  echo "the functions shown are not those of libspe2.h (< missing, > too many):"
  grep '^[<>]' "$work/difference"
  exit 1
fi

# Of spu_emu's own: the function's name, or its class's.
sed -nE 's/^spu_emu::([A-Za-z_]+).*/\1/p' "$work/shown" | sort -u >"$work/own"
for name in set_default_settings SettingsScope last_fault write_trace cycle_profile set_cycle_parameter; do
  grep -qx "$name" "$work/own" || { echo "spu_emu::$name is hidden"; exit 1; }
done
while read -r name; do
  grep -qw "$name" "$include_dir/spu_emu/emulation.h" "$include_dir/spu_emu/cycles.h" ||
    { echo "spu_emu::$name is shown, but no header declares it"; exit 1; }
done <"$work/own"
echo "$(wc -l <"$work/shown") symbols, all of them declared in the headers"
