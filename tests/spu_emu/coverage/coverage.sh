#!/bin/sh
# Prints what share of the SDK's names each header covers, and fails when a name beyond the known gaps is missing.
#
# Usage: coverage.sh COMPILER INCLUDE_DIR SDK_NAMES.tsv. Every row of the list is compiled as a check of its own
# (rows.awk); a row counts as covered when the compiler reports no error on it.
set -eu
compiler=$1
include_dir=$2
names=$3
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -f "$here/rows.awk" "$names" > "$work/rows.cpp"
case $($compiler --version) in
  *clang*) all_errors="-ferror-limit=0" ;;
  *) all_errors="-fmax-errors=0" ;;
esac
$compiler -std=c++17 -msse4.1 -fsyntax-only "$all_errors" -w -I"$include_dir" "$work/rows.cpp" 2> "$work/errors" || true

# An error outside the rows would make every count meaningless.
if grep -E '(error|fatal error):' "$work/errors" | grep -vq '^rows:'; then
  grep -E '(error|fatal error):' "$work/errors" | grep -v '^rows:' | head -5
  exit 2
fi
sed -nE 's/^rows:([0-9]+):.*error:.*/\1/p' "$work/errors" | sort -nu > "$work/missing"

if [ "$(tail -1 "$work/missing")" != 1000000 ]; then
  echo "the control row did not fail: the compiler did not check the rows"
  head -5 "$work/errors"
  exit 2
fi

awk -F '\t' -v gaps="$here/known_gaps.txt" '
  BEGIN { while ((getline line < gaps) > 0) { split(line, part, " "); if (line !~ /^#/) known[part[1]] = 1 } }
  NR == FNR { missing[$1] = 1; next }
  /^#/ || NF < 2 { next }
  {
    ++total[$1]
    if (!(FNR in missing)) { ++covered[$1]; next }
    if ($2 in known) ++excused[$1]
    else { ++unexcused; if (unexcused <= 60) print "missing: " $1 ": " $3 " " $2 "(" $4 ")" }
  }
  END {
    for (h in total)
      printf "%-26s %4d of %4d  %5.1f %%%s\n", h, covered[h], total[h], 100 * covered[h] / total[h],
             excused[h] ? "  (" excused[h] " known gaps)" : "" | "sort"
    close("sort")
    exit unexcused > 0
  }' "$work/missing" "$names"
