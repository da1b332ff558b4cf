#!/usr/bin/env bash
# Compiles GCC's own execution tests with the real SPU compiler and runs them on the instruction-level engine.
#
# usage: run.sh TESTSUITE COMPILER SPU_RUN [JOBS]
#   TESTSUITE  GCC's gcc/testsuite folder, with gcc.c-torture/execute and gcc.target/spu in it
# Every failure must be in known_failures.txt, with its reason, and everything in there must fail. What was compiled stays
# beside the compiler, where that may be written to, until either changes: two thirds of the time go into it.
set -euo pipefail
testsuite=$(realpath "$1")
compiler=$(realpath "$2")
spu_run=$(realpath "$3")
jobs=${4:-$(nproc)}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

list_tests() {
  (cd "$testsuite" && find gcc.c-torture/execute -name '*.c' -not -path '*/builtins/*')
  # Of the SPU's own tests those that say they run.
  (cd "$testsuite" && grep -lE 'dg-do run' gcc.target/spu/*.c)
}

# keep_programs FOLDER: makes it the place for programs, and forgets those of other versions of run_some.sh.
keep_programs() {
  mkdir -p "$1" 2>/dev/null && [ -w "$1" ] || return 0
  find "$(dirname "$1")" -mindepth 1 -maxdepth 1 -not -path "$1" -exec rm -rf {} +
  programs=$1
}

programs=$work/programs
mkdir "$programs"
keep_programs "$(dirname "$testsuite")/torture/$(cksum <"$here/run_some.sh" | tr ' ' -)"

export testsuite compiler spu_run programs
list_tests | LC_ALL=C sort > "$work/tests"
xargs -a "$work/tests" -P "$jobs" -n 16 "$here/run_some.sh" > "$work/results"

LC_ALL=C sort "$work/results" > "$work/sorted"
grep -v '^PASS\|^SKIP' "$work/sorted" | sed 's/^[A-Z]* //' | LC_ALL=C sort > "$work/failed" || true
sed -n 's/^\([^# ]*\):.*/\1/p' "$here/known_failures.txt" | LC_ALL=C sort > "$work/known"
cut -d' ' -f1 "$work/failed" > "$work/failed_names"

echo "passed $(grep -c ^PASS "$work/sorted"), failed $(wc -l < "$work/failed"), skipped $(grep -c ^SKIP "$work/sorted")" \
  "(the files say not to run them here) of $(wc -l < "$work/tests")"
status=0
while read -r name; do
  echo "failed, and not known to: $(grep "^$name " "$work/failed")"
  status=1
done < <(LC_ALL=C comm -23 "$work/failed_names" "$work/known")
while read -r name; do
  echo "in known_failures.txt, but it passed or was not run: $name"
  status=1
done < <(LC_ALL=C comm -13 "$work/failed_names" "$work/known")
exit $status
