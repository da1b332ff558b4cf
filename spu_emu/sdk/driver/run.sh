# cellrun: runs a host program that was compiled for the PowerPC half of a Cell. Sourced by driver.

run_usage() {
  cat <<'TEXT'
usage: cellrun [OPTIONS] PROGRAM [ARGUMENTS...]
Runs a program compiled by ppu-gcc, ppu-g++, ppu32-gcc or ppu32-g++, and its SPU
programs, on this machine: the PowerPC half by qemu-user, the SPUs by spu_emu.
Its exit code is the program's.

  --timeout SECONDS  end a program that has not ended by then, with exit code
                     124, and say which SPE waits for what
  --debug SPE        stop before this SPE's first instruction and ask; 0 is the
                     first SPE that the program makes. `help` there lists the
                     commands. SPU programs compiled with -g show their lines.
                     Several: 0,2 or all; each asks with its own prompt
  --debug-commands FILE
                     take the debugger's commands from the file, one a line; at
                     its end the SPE runs on. A % in the name stands for the
                     number of the SPE
  --help

Exit codes of cellrun itself: 124 out of time, 125 bad usage, 126 no program of
a Cell's PowerPC half, 127 not found.

Examples:
  ppu-gcc -o hello hello.c -lspe2 && cellrun hello
  cellrun --timeout 10 ./mandelbrot 640 480
  cellrun --debug 0 ./mandelbrot
  printf '%s\n' 'break main' continue backtrace >stops
  cellrun --debug 0 --debug-commands stops ./mandelbrot
TEXT
}

# refuse CODE TEXT
refuse() {
  say "$2"
  exit "$1"
}

# find_program NAME: as a path; a name without a folder is also looked for on the PATH.
find_program() {
  if [ -f "$1" ]; then
    echo "$1"
  else
    case $1 in */*) return 1 ;; *) command -v -- "$1" ;; esac
  fi
}

# check_kind PROGRAM KIND: refuses what cannot be run, and says what can.
check_kind() {
  case $2 in
    ppu32 | ppu64) ;;
    spu) refuse 126 "$1 is an SPU program; run it alone with spu-run, or embed it in a host program with embedspu" ;;
    x86 | i386) refuse 126 "$1 is a program of this machine (x86), not of a Cell; start it without cellrun" ;;
    ppc64le) refuse 126 "$1 is for little-endian PowerPC; a Cell's is big-endian: compile it with ppu-gcc" ;;
    object) refuse 126 "$1 is an object file; link it with ppu-gcc" ;;
    script) refuse 126 "$1 is a script; put cellrun before the programs that it starts" ;;
    empty) refuse 126 "$1 is empty or cannot be read" ;;
    *) refuse 126 "$1 is no program of a Cell's PowerPC half ($2); compile it with ppu-gcc" ;;
  esac
}

# emulator_of KIND: the command, in the caller's `emulator`. qemu's 64-bit processors clear the 128 bytes of a Cell's line
# with dcbz; its 32-bit ones with AltiVec clear 32, which ppu_intrinsics.h of this SDK makes up for.
emulator_of() {
  local root
  case $1 in
    ppu64) root=/usr/powerpc64-linux-gnu emulator=(qemu-ppc64) ;;
    ppu32) root=/usr/powerpc-linux-gnu emulator=(qemu-ppc -cpu 7400) ;;
  esac
  need "${emulator[0]}" qemu-user
  [ -e "$root/lib/libc.so.6" ] || fail "$root is missing; install it: apt-get install $(package_of "$1" g++)"
  emulator+=(-L "$root" -E "LD_LIBRARY_PATH=$sdk/$1/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}")
}

# check_debug SPE COMMANDS: what the debugger was asked for, before anything runs.
check_debug() {
  local number
  if [ -n "$1" ] && ! [[ $1 =~ ^(all|[0-9]{1,4}(,[0-9]{1,4})*)$ ]]; then
    refuse 125 "--debug: $1 is no number of an SPE; 0 is the first that the program makes. Several: 0,2 or all"
  fi
  [ -n "$2" ] || return 0
  [ -n "$1" ] || refuse 125 "--debug-commands wants --debug SPE as well, the SPE that they are for"
  # Of a file for each SPE only those that are named can be looked for.
  case $1/$2 in
    all/*%*) ;;
    *) for number in ${1//,/ }; do
        [ -f "${2/\%/$number}" ] && [ -r "${2/\%/$number}" ] ||
          refuse 127 "--debug-commands: ${2/\%/$number} is not there or cannot be read"
      done ;;
  esac
}

# debug SPES COMMANDS: what the library reads, by the environment, as qemu's -E would part it at commas. It has no libdw on
# that side: lines come from spu-run.
debug() {
  [ -n "$1" ] || return 0
  export SPU_EMU_DEBUG=$1 SPU_EMU_DEBUG_COMMANDS=$2
  SPU_EMU_LINE_READER="$(printf %q "$sdk/bin/spu-run") --list-lines"
  export SPU_EMU_LINE_READER
}

# run_in_time SECONDS PROGRAM ARGUMENT...: the library ends the process and says who waits for what; one that does not use
# it is killed soon after.
run_in_time() {
  local seconds=$1 program=$2 code=0 killed=137
  shift 2
  timeout --foreground --signal=KILL "$(awk -v s="$seconds" 'BEGIN {print s + 3}')" "${emulator[@]}" \
    -E "SPU_EMU_PROCESS_TIME_LIMIT=$seconds" -0 "$program" "$program" "$@" || code=$?
  [ $code -eq $killed ] || exit $code
  refuse 124 "$seconds s are over, and the program, which made no SPE, has not ended"
}

run() {
  local seconds= spe= commands= program kind emulator=()
  while [ $# -gt 0 ]; do
    case $1 in
      --help | -h) run_usage && return 0 ;;
      --timeout) [ $# -ge 2 ] || refuse 125 "--timeout wants seconds"
        seconds=$2
        shift 2
        ;;
      --timeout=*) seconds=${1#*=} && shift ;;
      --debug) [ $# -ge 2 ] || refuse 125 "--debug wants the number of an SPE; 0 is the first that the program makes"
        spe=${2:-\"\"}
        shift 2
        ;;
      --debug=*) spe=${1#*=} && spe=${spe:-\"\"} && shift ;;
      --debug-commands) [ $# -ge 2 ] || refuse 125 "--debug-commands wants a file"
        commands=$2
        shift 2
        ;;
      --debug-commands=*) commands=${1#*=} && shift ;;
      --) shift && break ;;
      -*) refuse 125 "unknown option: $1 (cellrun --help)" ;;
      *) break ;;
    esac
  done
  [ $# -gt 0 ] || { run_usage >&2 && exit 125; }
  if [ -n "$seconds" ] && ! [[ $seconds =~ ^[0-9]*\.?[0-9]+$ ]]; then refuse 125 "--timeout: $seconds is no number of seconds"; fi
  check_debug "$spe" "$commands"
  program=$(find_program "$1") || refuse 127 "$1 is not there"
  shift
  kind=$(kind_of "$program")
  check_kind "$program" "$kind"
  [ -x "$program" ] || refuse 126 "$program may not be executed (chmod +x)"
  emulator_of "$kind"
  debug "$spe" "$commands"
  [ -n "$seconds" ] || exec "${emulator[@]}" -0 "$program" "$program" "$@"
  run_in_time "$seconds" "$program" "$@"
}
