# The Debian packages that the toolchain's build needs, and how packages are installed. Sourced by build and sdk/install.

packages_of_toolchain=(gcc g++ make patch perl xz-utils bison flex texinfo gawk libgmp-dev libmpfr-dev libmpc-dev
  zlib1g-dev)

# install_packages NAME...: those that are missing; waits for another process that has apt locked.
install_packages() {
  [ -n "${CELLSWEEP_SKIP_PACKAGES:-}" ] && return 0
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "this is not Debian; install what $* hold, and set CELLSWEEP_SKIP_PACKAGES=1"
  local missing=() name
  for name in "$@"; do
    dpkg-query -W -f '${Status}' "$name" 2>/dev/null | grep -q 'ok installed' || missing+=("$name")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  [ "$(id -u)" -eq 0 ] || fail "missing packages, which only root can install: apt-get install ${missing[*]}"
  say "installing: ${missing[*]}"
  patient_apt_get update -qq &&
    DEBIAN_FRONTEND=noninteractive patient_apt_get install -y -qq --no-install-recommends "${missing[@]}"
}
