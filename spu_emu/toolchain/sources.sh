# Where the source tarballs come from: a folder given by the user, or Debian's mirror of this machine. Sourced by build.

tarballs() { cut -d ' ' -f 3 "$here/sources.sha256"; }

# The package as apt-get wants it, from the suite that has the version we build.
package_of() {
  case $1 in
    binutils_*) echo binutils/bookworm ;;
    gcc-9_*) echo gcc-9/bullseye ;;
    newlib_*) echo newlib/bookworm ;;
  esac
}

is_genuine() { (cd "$1" && grep -F "  $2" "$here/sources.sha256" | sha256sum --check --status) 2>/dev/null; }

# The machine's own Debian archive: the first entry that serves bookworm, as "URI<tab>keyring", from either format.
debian_archive() {
  local etc=${SPU_EMU_APT_DIR:-/etc/apt} file
  for file in "$etc"/sources.list.d/*.sources; do
    [ -f "$file" ] || continue
    awk -v RS= -F '\n' '{
      types = uris = suites = key = ""
      for (i = 1; i <= NF; ++i) {
        value = $i; sub(/^[^:]*:[ \t]*/, "", value)
        if ($i ~ /^Types:/) types = value
        if ($i ~ /^URIs:/) uris = value
        if ($i ~ /^Suites:/) suites = value
        if ($i ~ /^Signed-By:/) key = value
      }
      split(uris, uri, " ")
      if (" " types " " ~ / deb / && " " suites " " ~ / bookworm /) { print uri[1] "\t" key; exit }
    }' "$file"
  done
  for file in "$etc"/sources.list "$etc"/sources.list.d/*.list; do
    [ -f "$file" ] || continue
    sed -nE 's/^deb +(\[([^]]*)\] +)?([^ ]+) +bookworm .*/\3\t\2/p' "$file" |
      sed -E 's/\t.*signed-by=([^ ]+).*/\t\1/; t; s/\t.*/\t/'
  done
}

write_sources_file() {
  local uri key
  IFS=$'\t' read -r uri key < <(debian_archive | head -n 1) || true
  [ -n "${uri:-}" ] || fail "no entry for bookworm in the machine's apt sources; give the tarballs with --sources DIR"
  printf 'Types: deb-src\nURIs: %s\nSuites: bookworm bullseye\nComponents: main\n' "$uri"
  [ -z "${key:-}" ] || printf 'Signed-By: %s\n' "$key"
}

# Leaves the machine's apt setup alone: lists, caches and the sources file are our own.
our_apt() {
  apt-get -o "Dir::Etc::sourcelist=$work/apt/debian.sources" -o Dir::Etc::sourceparts=- \
    -o "Dir::State::lists=$work/apt/lists" -o "Dir::Cache=$work/apt/cache" -o APT::Sandbox::User= \
    -o Acquire::Check-Valid-Until=false -o Acquire::Retries=3 -q "$@"
}

reset_fetch() { :; }
stage_fetch() {
  mkdir -p "$work/tarballs" "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
  cd "$work/tarballs"
  local tarball missing=()
  for tarball in $(tarballs); do
    is_genuine . "$tarball" && continue
    if [ -n "$local_sources" ] && [ -f "$local_sources/$tarball" ]; then
      is_genuine "$local_sources" "$tarball" ||
        fail "$local_sources/$tarball has another checksum than sources.sha256 says"
      cp "$local_sources/$tarball" .
    else
      missing+=("$tarball")
    fi
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  write_sources_file >"$work/apt/debian.sources"
  our_apt update
  for tarball in "${missing[@]}"; do
    rm -f "$tarball"
    our_apt source --download-only --tar-only "$(package_of "$tarball")"
    is_genuine . "$tarball" || fail "the mirror's $tarball is missing or has another checksum than sources.sha256 says"
  done
}
