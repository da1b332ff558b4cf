# spu-gcc, ppu-g++ and the others: the compiler with what old programs take for granted. Sourced by driver.

# What is always given, before the caller's options, which may say otherwise.
flags_of() {
  case $1 in
    ppu64) echo -mcpu=cell -maltivec -flax-vector-conversions ;;
    # No processor of qemu's in 32 bits has a Cell's instructions for square roots and long conversions.
    ppu32) echo -mcpu=cell -maltivec -mno-powerpc64 -mno-powerpc-gpopt -flax-vector-conversions ;;
  esac
}

# read_line ARGUMENT...: what the command line says about itself; `partial` where it makes no program or starts it itself.
read_line() {
  local argument
  standard= common= static= spe2= math= partial= output= stage=link
  sources=()
  while [ $# -gt 0 ]; do
    argument=$1
    shift
    case $argument in
      -std=* | -ansi | --std=*) standard=$argument ;;
      -fcommon | -fno-common) common=$argument ;;
      -static) static=1 ;;
      -shared | -r | -nostdlib | -nostartfiles) partial=1 ;;
      -lspe2) spe2=1 ;;
      -lsimdmath) math=1 ;;
      -lspe) fail "-lspe is libspe 1.x, which is not here: the program must be ported to libspe2 (-lspe2)" ;;
      -c) stage=object ;;
      -E | -S | -M | -MM | -fsyntax-only) stage=text ;;
      -o) output=${1:-} ;;
      -o?*) output=${argument#-o} ;;
      -x | -I | -L | -D | -U | -include | -isystem | -MF | -MT | -MQ | -Xlinker | -T | -u) shift || true ;;
      -*) ;;
      *.c | *.cc | *.cpp | *.cxx | *.C | *.c++) sources+=("$argument") ;;
    esac
  done
}

# side_of SIDE ARGUMENT...: the PowerPC half's width by the last of -m32 and -m64.
side_of() {
  local side=$1 argument
  shift
  case $side in
    ppu*)
      for argument in "$@"; do
        case $argument in
          -m32) side=ppu32 ;;
          -m64) side=ppu64 ;;
        esac
      done
      ;;
  esac
  echo "$side"
}

is_cxx() {
  local source
  [ "$language" = g++ ] && return 0
  for source in "${sources[@]}"; do [ "${source##*.}" = c ] || return 0; done
  return 1
}

# What old code of the language is compiled as when it is refused as it stands.
old_standard() { if is_cxx; then echo -std=gnu++98 -fpermissive; else echo -std=gnu89; fi; }

# note_differences SIDE: says where -fcommon and -fgnu89-inline, which compilers before GCC 10 and 5 implied, mattered.
note_differences() {
  local object=$output source symbols
  for source in "${sources[@]}"; do
    if [ -z "$standard" ] && grep -qE '^[[:space:]]*(__)?inline\b' -- "$source" 2>/dev/null; then
      note "$source: plain inline functions are those of old C (-fgnu89-inline)"
    fi
  done
  [ -z "$common" ] && [ "$stage" = object ] && [ ${#sources[@]} -eq 1 ] || return 0
  [ -n "$object" ] || { object=${sources[0]##*/} && object=${object%.*}.o; }
  symbols=$("$(tool "$1" nm)" -- "$object" 2>/dev/null | awk '$2 == "C" {printf "%s%s", sep, $3; sep = ", "}') || return 0
  [ -z "$symbols" ] || note "${sources[0]}: may be defined in several files, as in old C (-fcommon): $symbols"
}

# attempt ERRORS COMMAND...: its exit code; what it says goes to the file.
attempt() {
  local errors=$1
  shift
  "$@" 2>"$errors"
}

# compile SIDE gcc|g++ ARGUMENT...
compile() {
  local side=$1 language=$2 compiler color=() line=() old=() code
  shift 2
  side=$(side_of "$side" "$@")
  compiler=$(tool "$side" "$language") || exit 1
  read_line "$@"
  # shellcheck disable=SC2046
  # A library counts wherever it stands on the line, also before the objects that use it.
  line=("$compiler" $(flags_of "$side") -isystem "$sdk/$side/include" "-L$sdk/$side/lib" -Wl,--no-as-needed)
  if [ ${#sources[@]} -gt 0 ] && ! is_cxx; then
    [ -n "$standard" ] || line+=(-fgnu89-inline)
    [ -n "$common" ] || line+=(-fcommon)
  fi
  while [ $# -gt 0 ]; do
    # The PowerPC compilers are one for each width.
    case $side/$1 in ppu*/-m32 | ppu*/-m64) ;; *) line+=("$1") ;; esac
    shift
  done
  # An archive before the objects that use it gives nothing.
  if [ -n "$static" ] && [ -n "$spe2" ]; then line+=(-lspe2); fi
  # Square roots and conversions of ppu_intrinsics.h are functions in 32 bits, and of a PPU's vectors of doubles all are.
  case $side/$stage/$math in ppu32/link/* | ppu64/link/1) line+=(-lm) ;; esac
  if [ $side/$stage = ppu32/link ] && [ -z "$partial" ]; then line+=("-Wl,$sdk/ppu32/lib/older_processor.o"); fi
  # Without sources nothing is there to be refused.
  if [ ${#sources[@]} -eq 0 ]; then exec "${line[@]}"; fi
  [ -t 2 ] && color=(-fdiagnostics-color=always)
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  code=0
  attempt "$scratch/first" "${line[@]}" "${color[@]}" || code=$?
  if [ $code -ne 0 ] && [ -z "$standard" ] && grep -qE ':[0-9]+: .*error: ' "$scratch/first"; then
    read -ra old <<<"$(old_standard)"
    if attempt "$scratch/second" "${line[@]}" "${old[@]}" "${color[@]}"; then
      cat "$scratch/second" >&2
      note "${sources[*]}: old code, compiled with ${old[*]}; without: $(grep -m 1 -E ':[0-9]+: .*error: ' "$scratch/first")"
      note_differences "$side"
      return 0
    fi
  fi
  cat "$scratch/first" >&2
  if [ $code -eq 0 ]; then note_differences "$side"; fi
  return $code
}

# binutil SIDE NAME ARGUMENT...
binutil() {
  local side=$1 command
  command=$(tool "$1" "$2") || exit 1
  shift 2
  if [ "${command##*-}" = ld ]; then set -- "$@" "-L$sdk/$side/lib"; fi
  exec "$command" "$@"
}
