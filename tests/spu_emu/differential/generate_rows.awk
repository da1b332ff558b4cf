# Turns each row of SDK_NAMES.tsv into functions that call the intrinsic on quadwords of 32-bit words: one SPU source
# for both engines. A row with immediates becomes one function for each of a few values.
#
# Variables: part (see part_of) and mode: `source` makes the SPU program's table, `host` its description for the test,
# `skipped` lists the names left out, each with the reason.
BEGIN {
  FS = "\t"
  count = 0
  fill_skipped()
  fill_immediates()
  fill_macros()
  if (mode == "source") print "#include \"differential/row.h\"\n\nnamespace {"
  if (mode == "host") print_host_head()
}

# What cannot be a function of its arguments, and where else it is tested.
function fill_skipped() {
  skip("channel access, tested in mfc and host", \
       "spu_readch spu_readchqw spu_readchcnt spu_writech spu_writechqw spu_mfcdma32 spu_mfcdma64 spu_mfcstat si_rdch si_rchcnt si_wrch")
  skip("stops the program, tested in host and isa", \
       "spu_hcmpeq spu_hcmpgt spu_stop si_heq si_heqi si_hgt si_hgti si_hlgt si_hlgti si_stop si_stopd")
  skip("control flow and state of the processor", \
       "spu_bisled spu_bisled_d spu_bisled_e spu_idisable spu_ienable spu_mfspr spu_mtspr si_bisled si_bisledd si_bislede si_mfspr si_mtspr")
  skip("the status register, recorded rows of hw_vectors.tsv", "spu_mffpscr spu_mtfpscr si_fscrrd si_fscrwr")
  skip("no result", \
       "spu_align_hint spu_sync spu_sync_c spu_dsync si_lnop si_nop si_sync si_syncc si_dsync vec_dss vec_dssall vec_dst vec_dstst vec_dststt vec_dstt vec_mtvscr vec_mfvscr")
  skip("no name of the real compiler", "spu_frest spu_frsqest fmas dfmas")
  skip("depends on an address of the program image", \
       "spu_lvsr spu_lvsl si_lqd si_lqx si_lqa si_lqr si_stqd si_stqx si_stqa si_stqr si_to_ptr si_from_ptr")
}

function skip(why, names,    list, n, i) {
  n = split(names, list, " ")
  for (i = 1; i <= n; ++i) skipped[list[i]] = why
}

function fill_immediates() {
  immediates["imm_s10"] = "-512 -1 0 7 511"
  immediates["imm_7"] = "0 1 5 31 127"
  immediates["imm_u7"] = "0 1 31 127"
  immediates["imm_s7"] = "-64 -1 0 3 63"
  immediates["imm_16"] = "0 1 32767 -32768"
  immediates["imm_s16"] = "0 1 32767 -32768"
  immediates["imm_u16"] = "0 1 32768 65535"
  immediates["imm_u18"] = "0 1 262143"
  immediates["scale"] = "0 1 31 127"
  immediates["test"] = "1 2 4 8 16 32 64 127"
  immediates["element"] = "0 1 3"
  immediates["signed5"] = "-16 0 15"
  immediates["bytes"] = "0 1 5 15"
}

# Argument types for the SDK's macros, alternatives separated by `;`.
function fill_macros() {
  any_integer = "vec_uchar16 @;vec_char16 @;vec_ushort8 @;vec_short8 @;vec_uint4 @;vec_int4 @"
  macro["vec_addc"] = macro["vec_subc"] = "vec_uint4, vec_uint4"
  macro["vec_cmpeq"] = "vec_uchar16, vec_uchar16;vec_ushort8, vec_ushort8;vec_uint4, vec_uint4;vec_float4, vec_float4"
  macro["vec_cmpgt"] = macro["vec_cmplt"] = \
    "vec_uchar16, vec_uchar16;vec_char16, vec_char16;vec_ushort8, vec_ushort8;vec_short8, vec_short8;" \
    "vec_uint4, vec_uint4;vec_int4, vec_int4;vec_float4, vec_float4"
  macro["vec_ctf"] = "vec_uint4, scale;vec_int4, scale"
  macro["vec_cts"] = macro["vec_ctu"] = "vec_float4, scale"
  macro["vec_madd"] = macro["vec_nmsub"] = "vec_float4, vec_float4, vec_float4"
  macro["vec_nor"] = "vec_uint4, vec_uint4;vec_uchar16, vec_uchar16;vec_short8, vec_short8"
  macro["vec_re"] = macro["vec_rsqrte"] = "vec_float4"
  macro["vec_sel"] = "vec_uint4, vec_uint4, vec_uint4;vec_float4, vec_float4, vec_uint4;vec_short8, vec_short8, vec_ushort8"
  macro["vec_sld"] = "vec_uint4, vec_uint4, bytes;vec_uchar16, vec_uchar16, bytes"
  macro["vec_sll"] = macro["vec_slo"] = macro["vec_srl"] = macro["vec_sro"] = "vec_uint4, vec_uint4;vec_uchar16, vec_uchar16"
  macro["vec_splat"] = macro["vec_extract"] = "vec_uint4, element;vec_float4, element;vec_short8, element;vec_uchar16, element"
  macro["vec_splat_s8"] = macro["vec_splat_s16"] = macro["vec_splat_s32"] = "signed5"
  macro["vec_splat_u8"] = macro["vec_splat_u16"] = macro["vec_splat_u32"] = "signed5"
  macro["vec_all_nan"] = "vec_float4"
  macro["vec_insert"] = "unsigned int, vec_uint4, element;short, vec_short8, element"
  macro["vec_promote"] = "unsigned int, element;float, element"
  macro["vec_splats"] = "unsigned int;float;short"
  macro["vec_ldl"] = "int a, vec_uint4 *b;int a, vec_char16 *b"
  macro["vec_lvlxl"] = macro["vec_lvrxl"] = "int a, unsigned int *b"
  macro["vec_stl"] = "vec_uint4 a, int b, vec_uint4 *c"
  macro["vec_stvlxl"] = macro["vec_stvrxl"] = "vec_uint4 a, int b, unsigned int *c"
}

function print_host_head(    program) {
  program = "differential_" part
  print "#include \"differential/programs.h\"\n"
  print "extern \"C\" spe_program_handle_t " program ", " program "_precise, " program "_elf;\n"
  print "namespace differential {\nnamespace {\nconst char* const calls[] = {"
}

function trim(s) {
  gsub(/^[ \t]+|[ \t]+$/, "", s)
  return s
}

# The type of one argument as the row writes it: `vec_uint4 a`, `int *b`, `imm_s10`.
function type_of(text) {
  text = trim(text)
  if (text ~ /\*[a-z]*$/) {
    sub(/ *\*[a-z]*$/, "*", text)
    return text
  }
  if (text ~ /^(vec_[a-z0-9]+|qword|int|float) (a|b|c|ra)$/) sub(/ [a-z]+$/, "", text)
  return text
}

function is_immediate(type) {
  return type in immediates
}

# Rows whose last argument must be a literal though the list does not say so.
function adjust(name, types, n) {
  if (name ~ /^spu_convt[fsu]$/) types[n] = "scale"
  if (name == "spu_testsv") types[n] = "test"
}

function argument(type, index_) {
  if (type ~ /^vec_|^qword$/) return "as_vector<" type ">(in[" index_ "])"
  return "scalar<" type ">(in[" index_ "])"
}

function add(call, shown) {
  if (mode == "host") print "    \"" shown "\","
  if (mode == "source") printf "vec_uint4 row%d(const vec_uint4* in) {\n  %s\n}\n", count, call
  ++count
}

# Declares the i-th argument as a variable: the SDK's own names are macros, which do not take template arguments.
function declare(type, i, index_) {
  return "const auto v" i " = " argument(type, index_) "; "
}

# A load or store: the pointer is into a block of vectors filled from the inputs.
function add_memory(name, types, n, shown,    element, code) {
  element = types[n]
  sub(/\*$/, "", element)
  code = "Memory<" element "> memory(in); const int at = offset<" element ">(in[2]); " element "* data = memory.data(); "
  if (n == 2) {
    add(code "const auto loaded = " name "(at, data); return words(loaded);", shown)
  } else {
    add(code declare(types[1], 1, 3) name "(v1, at, data); return memory.words();", shown)
  }
}

function add_call(name, types, n, values,    i, code, call, shown, shown_name, used) {
  shown_name = name
  used = 0
  for (i = 1; i <= n; ++i) {
    if (!is_immediate(types[i])) code = code declare(types[i], i, used++)
    call = call (i > 1 ? ", " : "") (is_immediate(types[i]) ? values[i] : "v" i)
    shown = shown (i > 1 ? ", " : "") (is_immediate(types[i]) ? values[i] : types[i])
  }
  code = code "const auto result = " name "(" call "); "
  # Only the preferred slot is defined.
  if (name ~ /^si_from_/) {
    sub(/^si_from_/, "si_to_", name)
    code = code "const auto scalar_again = " name "(result); "
    return add(code "return words(scalar_again);", shown_name "(" shown ")")
  }
  # Only the element named is defined.
  if (name ~ /^(spu|vec)_promote$/) {
    code = code "const auto element = spu_extract(result, " (is_immediate(types[n]) ? values[n] : "v" n) "); "
    return add(code "return words(element);", name "(" shown ")")
  }
  add(code "return words(result);", name "(" shown ")")
}

function add_alternatives(name, list,    types, n, i, values, choices, k, at) {
  n = (trim(list) == "" || trim(list) == "void") ? 0 : split(list, types, ",")
  for (i = 1; i <= n; ++i) types[i] = type_of(types[i])
  adjust(name, types, n)
  if (n > 0 && types[n] ~ /\*$/) return add_memory(name, types, n, name "(" list ")")
  at = 0
  for (i = 1; i <= n; ++i) if (is_immediate(types[i])) at = i
  if (at == 0) return add_call(name, types, n, values)
  k = split(immediates[types[at]], choices, " ")
  for (i = 1; i <= k; ++i) {
    values[at] = choices[i]
    add_call(name, types, n, values)
  }
}

function part_of(    header) {
  header = $1
  if (header ~ /generic/) return $2 < "spu_m" ? "generic_1" : "generic_2"
  if (header ~ /specific/) return "specific"
  if (header == "vmx2spu.h" && $2 !~ /^vec_types/) return $2 < "vec_b" ? "vmx_1" : $2 < "vec_o" ? "vmx_2" : "vmx_3"
  return ""
}

/^#/ || NF < 2 { next }
part_of() != part { next }
$2 in skipped {
  if (mode == "skipped" && !($2 in told)) print $2 ": " skipped[$2]
  told[$2] = 1
  next
}
$3 ~ /^macro/ {
  n_alternatives = split(macro[$2], alternatives, ";")
  for (a = 1; a <= n_alternatives; ++a) add_alternatives($2, alternatives[a])
  next
}
{ add_alternatives($2, $4) }

END {
  if (mode == "host") {
    print "};\n}  // namespace\n\nProgram program_" part "() {\n  return {\"" part "\", calls, " count ", &differential_" part \
      ", &differential_" part "_precise, &differential_" part "_elf};\n}\n}  // namespace differential"
  }
  if (mode == "source") {
    print "}  // namespace\n\nconst Row rows[] = {"
    for (i = 0; i < count; ++i) printf "row%d,%s", i, i % 8 == 7 ? "\n" : " "
    print "};\nconst unsigned row_count = " count ";"
  }
}
