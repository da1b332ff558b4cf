# Checks of a finished toolchain, by what it makes and, with a runner, by what that does. Sourced by build.

# expect WHAT COMMAND...: one line of the result; counts failures in the caller's `failures`.
expect() {
  local what=$1
  shift
  if "$@"; then
    say "  good    $what"
  else
    say "  BROKEN  $what"
    failures=$((failures + 1))
  fi
}

compiles() { "$toolchain/bin/spu-elf-g++" -std=c++17 -O2 -Wall -Wextra -Werror "$here/checks/$1.cpp" -o "$scratch/$1"; }
nop_is_an_instruction() {
  printf 'nop 127\n' | "$toolchain/bin/spu-elf-as" -o "$scratch/nop.o" &&
    "$toolchain/bin/spu-elf-objdump" -d "$scratch/nop.o" | grep -q '40 20 00 7f'
}
constructors_are_where_start_up_looks() {
  local sections
  sections=$("$toolchain/bin/spu-elf-readelf" -SW "$scratch/constructors") || return 1
  grep -q ' \.ctors ' <<<"$sections" && ! grep -q ' \.init_array ' <<<"$sections" &&
    "$toolchain/bin/spu-elf-nm" "$scratch/constructors" | grep -q ' __do_global_ctors_aux$'
}
runs() { "$runner" "$scratch/$1"; }
prints() { [ "$("$runner" "$scratch/printing")" = 'spu 23 0.25' ]; }

# check_toolchain FOLDER [RUNNER]: fails when something that SPU programs need does not work.
check_toolchain() {
  local toolchain=$1 runner=${2:-} failures=0 scratch program
  [ -x "$toolchain/bin/spu-elf-g++" ] || fail "there is no toolchain in $toolchain"
  scratch=$(mktemp -d)
  say "checking $toolchain"
  expect "nop is an instruction" nop_is_an_instruction
  expect "global objects compile" compiles constructors
  expect "constructors are where the start-up code looks" constructors_are_where_start_up_looks
  expect "C++17 compiles" compiles cxx17
  expect "the SDK's headers compile" compiles headers
  expect "printf links" compiles printing
  if [ -n "$runner" ]; then
    for program in constructors cxx17 headers; do expect "$program runs" runs "$program"; done
    expect "printf prints" prints
  fi
  rm -rf "$scratch"
  [ "$failures" -eq 0 ]
}
