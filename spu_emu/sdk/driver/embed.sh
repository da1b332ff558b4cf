# embedspu: an SPU program becomes an object of the host side, with a handle for spe_program_load. Sourced by driver.

embed_usage() {
  cat <<'TEXT'
usage: embedspu [-m32 | -m64 | --x86] SYMBOL PROGRAM OBJECT
Puts the SPU ELF file PROGRAM into OBJECT, an object file of the host side, which defines
  spe_program_handle_t SYMBOL;
ppu-embedspu and embedspu are for 64 bits unless told otherwise, ppu32-embedspu for 32.
Symbols _EAR_name of PROGRAM, in its section .toe, get the address of the host's symbol name; _EAR_ that of the image.

Example:
  spu-gcc -O2 -o kernel kernel.c
  ppu-embedspu kernel kernel kernel-embed.o
  ppu-gcc -o program main.c kernel-embed.o -lspe2
TEXT
}

# effective_addresses PROGRAM SIDE: what the assembler is to make of the program's symbols _EAR_name, the addresses of the
# host's symbols. One in the section .toe gets a quadword of the handle's table, from which libspe2 fills the section; one
# elsewhere is put into the image by the linker, in a Cell's byte order. _EAR_ alone is the image.
effective_addresses() {
  "$(tool spu readelf)" -W -S -s -- "$1" | awk -v side="$2" -v program="$1" '
    function number(hex,  i, value) {
      for (i = 1; i <= length(hex); ++i) value = value * 16 + index("0123456789abcdef", substr(tolower(hex), i, 1)) - 1
      return value + 0
    }
    function refuse(text) {
      print program ": " text > "/dev/stderr"
      failed = 1
      exit 1
    }
    function quadword(name) {
      if (side == "ppu32") return ".long 0, " name ", 0, 0"
      return ".quad " name ", 0"
    }
    /^ *\[ *[0-9]+\]/ {
      sub(/^ *\[ */, "")
      sub(/\]/, "")
      type[$1] = $3; address[$1] = number($4); offset[$1] = number($5); size[$1] = number($6)
      if ($2 == ".toe") toe = $1
    }
    /^ *[0-9]+:/ && $8 ~ /^_EAR_/ && $7 != "UND" {
      name = $8 == "_EAR_" ? ".Limage" : substr($8, 6)
      at = number($2) - address[$7]
      if ($7 == toe) {
        if (at % 16 != 0) refuse($8 " is no quadword of the section .toe")
        if (at in entry && entry[at] != name) refuse($8 " and _EAR_" entry[at] " are in the same quadword of .toe")
        entry[at] = name
      } else if (side == "x86" && $8 != "_EAR_") {
        refuse($8 " is not in the section .toe; only there a host of another byte order can give its address")
      } else if (type[$7] != "PROGBITS") {
        refuse($8 " has no bytes in the file: put it into the section .toe, or initialise it")
      } else if (side != "x86") {
        relocated = relocated sprintf(".reloc .Limage+%d, %s, %s\n", offset[$7] + at + (side == "ppu32" ? 4 : 0),
          side == "ppu32" ? "R_PPC_ADDR32" : "R_PPC64_ADDR64", name)
      }
    }
    END {
      if (failed) exit 1
      if (relocated != "") printf "%s", relocated
      if (toe == "" || size[toe] == 0) exit 0
      print ".section .data.spetoe, \"aw\", @progbits\n.balign 16\n.Ltoe:"
      for (at = 0; at < size[toe]; at += 16) print quadword(at in entry ? entry[at] : "0")
    }'
}

# assembler_of PROGRAM SYMBOL SIDE ADDRESSES: the object's source. The handle is {its size, the image, the shadow of .toe}.
assembler_of() {
  local word=.quad handle=24 toe=0 section='.rodata.speelf, "a"'
  if [ "$3" = ppu32 ]; then word=.long handle=12; fi
  case $4 in *.Ltoe:*) toe=.Ltoe ;; esac
  case $4 in *.reloc*) section='.data.rel.ro.speelf, "aw"' ;; esac
  cat <<TEXT
.section $section, @progbits
.balign 128
.Limage:
.incbin "$1"
.balign 64
$4
.section .data.spehandle, "aw", @progbits
.balign 8
.globl $2
.type $2, @object
$2:
.long $handle
$([ "$3" = ppu32 ] || echo .long 0)
$word .Limage
$word $toe
.size $2, . - $2
.section .note.GNU-stack, "", @progbits
TEXT
}

# embed SIDE ARGUMENT...
embed() {
  local side=$1 words=() kind addresses
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
  addresses=$(effective_addresses "$program" "$side") || fail "$program cannot be embedded"
  assembler_of "$(realpath -- "$program")" "$symbol" "$side" "$addresses" | "$(tool "$side" gcc)" -c -x assembler - -o "$object"
}
