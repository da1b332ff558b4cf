#!/usr/bin/env bash
# Compiles and runs the tests named; one line each: PASS name, SKIP name why, or FAIL name why. Called by run.sh.
set -u

# The text in quotes of a line such as  { dg-options "-fwrapv" }  as far as it is for every target.
options_of() {
  sed -nE 's/.*dg-(additional-)?options +\{? *"([^"]*)" *\}? *(\{ *target +spu[^}]*\} *)?\}.*/\2/p' "$1" | tr '\n' ' '
}

# Why the file's own directives rule the test out on an SPU, if they do.
ruled_out() {
  if grep -qE 'dg-(skip-if|xfail-run-if|xfail-if).*spu' "$1"; then
    echo "the file names the SPU"
  elif grep -qE 'dg-require-effective-target +(int128|dfp|mmap|pthread)' "$1"; then
    echo "the file requires what an SPU does not have"
  elif grep -E 'dg-do run *\{ *target' "$1" | grep -qv spu || grep -q 'dg-skip-if "" { ! *{ *i?86' "$1"; then
    echo "the file is for another target"
  fi
}

# compile NAME PROGRAM: unless it is there. Its errors stand in PROGRAM.errors.
compile() {
  [ -e "$2" ] && return 0
  local source=$testsuite/$1 options
  read -ra options <<< "$(options_of "$source")"
  # What the tests take for the size of the stack where it is small.
  if grep -q 'dg-add-options stack_size' "$source"; then options+=(-DSTACK_SIZE=65536); fi
  (cd "$programs" && "$compiler" -O2 -w "${options[@]}" "$source" -lm -s -o "$2.new") 2> "$2.errors" && mv "$2.new" "$2"
}

for name in "$@"; do
  source=$testsuite/$name
  why=$(ruled_out "$source")
  if [ -n "$why" ]; then
    echo "SKIP $name $why"
    continue
  fi
  program=$programs/${name//\//_}.elf
  if ! compile "$name" "$program"; then
    echo "FAIL $name does not compile: $(grep -m1 -E 'error|undefined|overflow' "$program.errors")"
  elif timeout 60 "$spu_run" --max-instructions 3000000000 "$program" > /dev/null 2> "$program.errors" < /dev/null; then
    echo "PASS $name"
  else
    echo "FAIL $name exit code $?: $(grep -v '^$' "$program.errors" | head -1)"
  fi
  rm -f "$program.errors" "$program.new"
done
