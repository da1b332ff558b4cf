# cellcc: the compiler of the host side, for a Cell's PowerPC half or for this machine. Sourced by driver.

cellcc_usage() {
  cat <<'TEXT'
usage: cellcc [--x86] [--c++] OPTIONS AND FILES of gcc...
Compiles and links the host side of a Cell program.

  --x86   for this machine instead of a Cell's PowerPC half. The program runs without cellrun, and faster; but the byte
          order of host and SPU differs then: 32-bit words are exchanged right, other widths are not. Embed its SPU
          programs with embedspu --x86.
  --c++   link with the C++ library (C++ sources do so by themselves)
  -m32    the PowerPC half in 32 bits

Examples:
  cellcc -O2 -o program main.c kernel-embed.o -lspe2      # the same as ppu-gcc
  embedspu --x86 kernel kernel kernel-x86.o
  cellcc --x86 -O2 -o program main.c kernel-x86.o -lspe2 && ./program
TEXT
}

cellcc() {
  local side=ppu64 language=gcc line=() argument
  for argument in "$@"; do
    case $argument in
      --help) cellcc_usage && return 0 ;;
      --x86) side=x86 ;;
      --c++) language=g++ ;;
      *.cpp | *.cc | *.cxx | *.C | *.c++) language=g++ && line+=("$argument") ;;
      *) line+=("$argument") ;;
    esac
  done
  if [ $side = x86 ]; then line+=("-Wl,-rpath,$sdk/x86/lib"); fi
  compile "$side" "$language" "${line[@]}"
}
