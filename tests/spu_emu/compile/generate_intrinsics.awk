# Makes of SDK_NAMES.tsv what C sources need of the vector intrinsics, for C has no overloads: a function with a name of
# its own for every row, and a macro that chooses among them by the types of its arguments.
#
# Variable mode: `list` makes include/spu_emu/c/intrinsic_list.h, `macros` include/spu_emu/c/intrinsic_choice.h.
BEGIN {
  FS = "\t"
  split("a b c", letters, " ")
  n = split("spu_bisled spu_bisled_d spu_bisled_e spu_idisable spu_ienable spu_align_hint spu_mfspr spu_mtspr " \
    "spu_mffpscr spu_mtfpscr spu_dsync spu_stop spu_sync spu_sync_c spu_readch spu_readchqw spu_readchcnt spu_writech " \
    "spu_writechqw spu_mfcdma32 spu_mfcdma64 spu_mfcstat spu_hcmpeq spu_hcmpgt spu_lvsr spu_lvsl si_heq si_heqi si_hgt " \
    "si_hgti si_hlgt si_hlgti si_bisled si_bisledd si_bislede si_stop si_stopd si_lnop si_nop si_sync si_syncc si_dsync " \
    "si_mfspr si_mtspr si_rdch si_rchcnt si_wrch " \
    "si_lqa si_lqr si_stqa si_stqr", names, " ")
  for (i = 1; i <= n; ++i) by_hand[names[i]] = 1
}

# The type of an argument: without its name, and an immediate is an int.
function type_of(text) {
  gsub(/^ +| +$/, "", text)
  sub(/^(imm|scale|element).*/, "int", text)
  sub(/ ra$/, "", text)
  return text
}

($1 == "spu_intrinsics.h generic" || $1 == "spu_intrinsics.h specific") && !($2 in by_hand) && $3 != "" {
  name = $2
  if (!(name in rows)) order[++ordered] = name
  row = ++rows[name]
  count = $4 == "void" || $4 == "" ? 0 : split($4, types, ",")
  arity[name] = count
  result[name, row] = $3
  key = ""
  for (i = 1; i <= count; ++i) {
    type[name, row, i] = type_of(types[i])
    key = key "," type[name, row, i]
  }
  if ((name key) in seen) --rows[name]
  seen[name key] = 1
}

END {
  if (mode == "list") print_list()
  else print_macros()
}

function print_list(    i, name, row, k) {
  print "// Every vector intrinsic as SPU_EMU_C<arguments>(name, row, result, argument types). Made from the list of"
  print "// the SDK's names by tests/spu_emu/compile/generate_intrinsics.awk."
  print "// clang-format off"
  for (i = 1; i <= ordered; ++i) {
    name = order[i]
    for (row = 1; row <= rows[name]; ++row) {
      printf "SPU_EMU_C%d(%s, %d, %s", arity[name], name, row, result[name, row]
      for (k = 1; k <= arity[name]; ++k) printf ", %s", type[name, row, k]
      print ")"
    }
  }
}

function print_macros(    i, name, all, row) {
  print "// Chooses an intrinsic by the types of its arguments. Made from the list of the SDK's names by"
  print "// tests/spu_emu/compile/generate_intrinsics.awk."
  print "// clang-format off"
  for (i = 1; i <= ordered; ++i) {
    name = order[i]
    all = ""
    for (row = 1; row <= rows[name]; ++row) all = all " " row
    print_macro(name, all)
  }
}

function print_macro(name, all,    k, parameters, values, locals, chosen) {
  chosen = choice(name, all, 1)
  for (k = 1; k <= arity[name]; ++k) {
    parameters = parameters (k > 1 ? ", " : "") letters[k]
    values = values (k > 1 ? ", " : "") "spu_emu_" letters[k]
    locals = locals "__auto_type spu_emu_" letters[k] " = (" letters[k] "); "
  }
  if (chosen !~ /_Generic/) printf "#define %s(%s) %s(%s)\n", name, parameters, chosen, parameters
  else printf "#define %s(%s) __extension__({ %s%s(%s); })\n", name, parameters, locals, chosen, values
}

function is_vector(text) {
  return text ~ /^(vec_|qword)/
}

# Whether what is behind argument k tells the rows with a scalar there apart.
function later_tells(name, list, n, k,    i, j, key, keys) {
  delete keys
  for (i = 1; i <= n; ++i) {
    if (is_vector(type[name, list[i], k])) continue
    key = ""
    for (j = k + 1; j <= arity[name]; ++j) if (is_vector(type[name, list[i], j])) key = key "," type[name, list[i], j]
    if (key in keys || key == "") return 0
    keys[key] = 1
  }
  return 1
}

# The function of the rows of `all`, by the types of argument k and those behind it.
function choice(name, all, k,    n, list, i, text, group, groups, ngroups, scalars, nscalars, merged, one) {
  n = split(all, list, " ")
  if (n == 1 || k > arity[name]) return "spu_emu_c_" name "_" list[1]
  ngroups = nscalars = 0
  merged = ""
  for (i = 1; i <= n; ++i) {
    text = type[name, list[i], k]
    if (!(text in group)) {
      groups[++ngroups] = text
      if (!is_vector(text)) scalars[++nscalars] = text
    }
    group[text] = group[text] " " list[i]
    if (!is_vector(text)) merged = merged " " list[i]
  }
  if (ngroups == 1) return choice(name, all, k + 1)
  text = ""
  one = nscalars == 1 || (nscalars > 1 && later_tells(name, list, n, k))
  for (i = 1; i <= ngroups; ++i) {
    if (is_vector(groups[i])) text = text ", " groups[i] ": " choice(name, group[groups[i]], k + 1)
    else if (!one) text = text scalar_choice(name, groups[i], group[groups[i]], group, k)
  }
  if (one) text = text ", default: " choice(name, merged, k + 1)
  return "_Generic(spu_emu_" letters[k] text ")"
}

# A plain char is unsigned, and long has 64 bits here; on an SPU it had 32.
function scalar_choice(name, scalar, list, group, k,    chosen, text) {
  chosen = choice(name, list, k + 1)
  text = ", " scalar ": " chosen
  if (scalar == "unsigned char") text = text ", char: " chosen
  if (scalar == "long long") text = text ", long: " chosen
  if (scalar == "unsigned long long") text = text ", unsigned long: " chosen
  return text
}
