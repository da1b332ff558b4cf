# What the commands of the SDK share: where things are, and words for people. Sourced by driver.

say() { printf '%s: %s\n' "$name" "$*" >&2; }

fail() {
  say "error: $*"
  exit 1
}

# note TEXT: what was done beyond what the command line says.
note() { [ "${CELL_SDK_NOTES:-1}" = 0 ] || say "note: $*"; }

# need COMMAND PACKAGE: fails with the package's name where the command is missing.
need() { command -v "$1" >/dev/null || fail "$1 is missing; install it: apt-get install $2"; }

# The folder of the SPU compiler: of the environment, else the one that the SDK was installed with.
toolchain() {
  local folder=${SPU_EMU_TOOLCHAIN_DIR:-$(cat "$sdk/toolchain")}
  [ -f "$folder/complete" ] || fail "there is no SPU compiler in $folder; build it with spu_emu/toolchain/build"
  echo "$folder"
}

# Each side that code is compiled for: ppu64, ppu32, x86 or spu.
# target_of SIDE: what its tools' names begin with.
target_of() {
  case $1 in
    ppu64) echo powerpc64-linux-gnu- ;;
    ppu32) echo powerpc-linux-gnu- ;;
    spu) echo "$(toolchain)/bin/spu-elf-" ;;
    x86) echo ;;
  esac
}

# package_of SIDE TOOL: what holds the tool.
package_of() {
  case $1/$2 in
    ppu64/g* | ppu64/c*) echo g++-powerpc64-linux-gnu ;;
    ppu32/g* | ppu32/c*) echo g++-powerpc-linux-gnu ;;
    ppu64/*) echo binutils-powerpc64-linux-gnu ;;
    ppu32/*) echo binutils-powerpc-linux-gnu ;;
    x86/g* | x86/c*) echo g++ ;;
    *) echo binutils ;;
  esac
}

# tool SIDE NAME: the command, which is there.
tool() {
  local prefix
  prefix=$(target_of "$1") || exit 1
  need "$prefix$2" "$(package_of "$1" "$2")"
  echo "$prefix$2"
}

# word FILE OFFSET BYTES: a big-endian number of the file, in decimal; nothing where the file ends before.
number_at() {
  local byte value=0 bytes
  bytes=$(od -An -v -tu1 -j "$2" -N "$3" -- "$1" 2>/dev/null) || return 0
  for byte in $bytes; do value=$((value * 256 + byte)); done
  [ -z "$bytes" ] || echo "$value"
}

# kind_of FILE: spu, ppu32, ppu64, x86, object and so on, by the header of an ELF file; script, empty or other.
kind_of() {
  local magic class order machine type
  magic=$(od -An -v -tx1 -N 4 -- "$1" 2>/dev/null | tr -d ' \n')
  case $magic in
    7f454c46) ;;
    2321*) echo script && return ;;
    '') echo empty && return ;;
    *) echo other && return ;;
  esac
  class=$(number_at "$1" 4 1)
  order=$(number_at "$1" 5 1)
  type=$(number_at "$1" 16 2)
  machine=$(number_at "$1" 18 2)
  if [ "$order" = 1 ]; then # Little-endian.
    type=$((type / 256 + type % 256 * 256))
    machine=$((machine / 256 + machine % 256 * 256))
  fi
  if [ "$type" = 1 ]; then echo object && return; fi
  case $machine/$class/$order in
    20/1/2) echo ppu32 ;;
    21/2/2) echo ppu64 ;;
    21/2/1) echo ppc64le ;;
    23/1/2) echo spu ;;
    62/*) echo x86 ;;
    3/*) echo i386 ;;
    *) echo "machine $machine" ;;
  esac
}
