# Turns each row of SDK_NAMES.tsv into one C++ check whose compiler errors name the row's own line.
#
# Typed rows: the call on values of exactly the row's argument types must have exactly the row's return type.
# Rows with argument names only: a call with that many arguments of a type that converts to anything must compile.
# Types and constants of libspe2.h: a size in bytes with 64-bit pointers, and a value.
# Rows with a name only: functions must have an address, constants and types a size.
BEGIN {
  FS = "\t"
  print "#include <spu_intrinsics.h>"
  print "#include <vmx2spu.h>"
  print "#if __has_include(<spu_mfcio.h>)\n#include <spu_mfcio.h>\n#endif"
  print "#if __has_include(<libspe2.h>)\n#include <libspe2.h>\n#endif"
  print "#include <type_traits>\n#include <utility>"
  print "struct Any { template <typename T> operator T() const; };"
  print "template <typename T> T value();"
  fill_macro_arguments()
}

function trim(s) {
  gsub(/^[ \t]+|[ \t]+$/, "", s)
  return s
}

# Sample arguments for what the SDK defines as macros of vmx2spu.h; unnamed ones take two vec_uint4.
function fill_macro_arguments() {
  f = "value<vec_float4>()"; u = "value<vec_uint4>()"; p = "value<float*>()"; v = "value<void*>()"
  sample["vec_ctf"] = "value<vec_int4>(), 1"; sample["vec_cts"] = f ", 1"; sample["vec_ctu"] = f ", 1"
  sample["vec_dss"] = "0"; sample["vec_dssall"] = " "
  sample["vec_dst"] = sample["vec_dstst"] = sample["vec_dststt"] = sample["vec_dstt"] = v ", 0, 0"
  sample["vec_ldl"] = sample["vec_lvlxl"] = sample["vec_lvrxl"] = "0, " p
  sample["vec_stl"] = sample["vec_stvlxl"] = sample["vec_stvrxl"] = f ", 0, " p
  sample["vec_madd"] = sample["vec_nmsub"] = f ", " f ", " f
  sample["vec_mtvscr"] = u; sample["vec_re"] = sample["vec_rsqrte"] = sample["vec_all_nan"] = f
  sample["vec_sel"] = u ", " u ", " u; sample["vec_sld"] = u ", " u ", 3"
  sample["vec_splat"] = sample["vec_extract"] = u ", 1"; sample["vec_insert"] = "1u, " u ", 1"
  sample["vec_promote"] = "1u, 1"; sample["vec_splats"] = "1u"
  sample["vec_splat_s8"] = sample["vec_splat_s16"] = sample["vec_splat_s32"] = "1"
  sample["vec_splat_u8"] = sample["vec_splat_u16"] = sample["vec_splat_u32"] = "1"
}

# One argument as the row writes it, `vec_uint4 a`, `int *b`, `imm_s10` or `tag`, as a C++ expression.
function argument(text) {
  text = trim(text)
  if (text ~ /^(imm|imm_.*|ra|a|any)$/) return "value<Any>()"
  if (text ~ /\*[a-z]*$/) sub(/\*[a-z]*$/, "*", text)
  else if (text ~ /^(volatile )?(vec_[a-z0-9]+|qword|(un)?signed (int|char|short)|unsigned long long|long long|int|void|float|double|short) [a-z]+$/ && text !~ /^(un)?signed (int|char|short|long)$/ && text !~ /^(unsigned )?long long$/)
    sub(/ [a-z]+$/, "", text)
  return "value<" text ">()"
}

function arguments(list,    parts, n, i, out) {
  list = trim(list)
  if (list == "" || list == "void") return ""
  n = split(list, parts, ",")
  for (i = 1; i <= n; ++i) out = out (i > 1 ? ", " : "") argument(parts[i])
  return out
}

function any_arguments(list,    parts, n, i, out) {
  list = trim(list)
  if (list == "" || list == "void") return ""
  n = split(list, parts, ",")
  for (i = 1; i <= n; ++i) out = out (i > 1 ? ", " : "") (parts[i] == "lsa" ? "value<mfc_list_element_t*>()" : "value<Any>()")
  return out
}

# The error of a missing name must come from this line alone, so every check is a function or assertion of its own.
function check(code) {
  printf "#line %d \"rows\"\n%s\n", NR, code
}

/^#/ || NF < 2 { next }

$1 == "libspe2.h type" { check("static_assert(sizeof(" $2 ") == " $3 ");"); next }

$1 == "libspe2.h constant" { check("static_assert(" $2 " == " $3 ");"); next }

$1 == "libspe2.h" { check("const auto check" NR " = &" $2 ";"); next }

$1 == "spu_mfcio.h" && ($2 ~ /^(SPU|MFC)_[A-Z]/ && $4 == "" || $2 ~ /_t$/) {
  check("constexpr auto check" NR " = sizeof(" $2 ");"); next
}

$1 == "spu_mfcio.h" { check("inline void check" NR "() { static_cast<void>(" $2 "(" any_arguments($4) ")); }"); next }

$2 == "vec_types.h" {
  check("static_assert(std::is_same<" $3 ", " $4 ">::value, \"row\");"); next
}

$3 ~ /^macro/ {
  args = ($2 in sample) ? sample[$2] : "value<vec_uint4>(), value<vec_uint4>()"
  check("inline void check" NR "() { static_cast<void>(" $2 "(" args ")); }"); next
}

trim($3) == "" { check("inline void check" NR "() { static_cast<void>(" $2 "(" arguments($4) ")); }"); next }

{ check("static_assert(std::is_same<decltype(" $2 "(" arguments($4) ")), " trim($3) ">::value, \"row\");") }

# A row that must fail: proof that failures are seen.
END { print "#line 1000000 \"rows\"\nstatic_assert(std::is_same<decltype(spu_add(value<vec_int4>(), value<vec_uint4>())), int>::value, \"\");" }
