# embedspu: an SPU program becomes an object of the host side, with a handle for spe_program_load. Sourced by driver.

embed_usage() {
  cat <<'TEXT'
usage: embedspu [-m32 | -m64 | --x86] SYMBOL PROGRAM OBJECT
Puts the SPU ELF file PROGRAM into OBJECT, an object file of the host side, which defines
  spe_program_handle_t SYMBOL;
ppu-embedspu and embedspu are for 64 bits unless told otherwise, ppu32-embedspu for 32.

Example:
  spu-gcc -O2 -o kernel kernel.c
  ppu-embedspu kernel kernel kernel-embed.o
  ppu-gcc -o program main.c kernel-embed.o -lspe2
TEXT
}

# assembler_of PROGRAM SYMBOL WIDTH: the object's source. The handle is {its size, the image, the shadow of .toe}.
assembler_of() {
  local word=.long handle=12
  if [ "$3" = 64 ]; then word=.quad handle=24; fi
  cat <<TEXT
.section .rodata.speelf, "a", @progbits
.balign 128
.Limage:
.incbin "$1"
.balign 64
.section .data.spehandle, "aw", @progbits
.balign 8
.globl $2
.type $2, @object
$2:
.long $handle
$([ "$3" = 64 ] && echo .long 0)
$word .Limage
$word 0
.size $2, . - $2
.section .note.GNU-stack, "", @progbits
TEXT
}

# embed SIDE ARGUMENT...
embed() {
  local side=$1 words=() width=64 kind
  shift
  while [ $# -gt 0 ]; do
    case $1 in
      -m32) side=ppu32 ;;
      -m64) side=ppu64 ;;
      --x86) side=x86 ;;
      --help | -h) embed_usage && return 0 ;;
      -*) ;; # Flags of the compiler, which change nothing in data.
      *) words+=("$1") ;;
    esac
    shift
  done
  [ ${#words[@]} -eq 3 ] || { embed_usage >&2 && fail "SYMBOL, PROGRAM and OBJECT are needed, not ${#words[@]} names"; }
  local symbol=${words[0]} program=${words[1]} object=${words[2]}
  [[ $symbol =~ ^[A-Za-z_][A-Za-z0-9_]*$ ]] || fail "$symbol cannot be the name of a variable in C"
  [ -r "$program" ] || fail "$program cannot be read"
  kind=$(kind_of "$program")
  [ "$kind" = spu ] || fail "$program is no SPU program (it is: $kind); link it with spu-gcc"
  [ "$side" = ppu32 ] && width=32
  assembler_of "$(realpath -- "$program")" "$symbol" "$width" | "$(tool "$side" gcc)" -c -x assembler - -o "$object"
}
