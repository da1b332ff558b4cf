# Shared by ./run and ./test: installs what is missing and builds. Sourced, not run; the caller stands in the
# project's folder. Everything here speaks on standard error, so that standard output stays the program's.

packages_to_build=(g++ cmake ninja-build pkg-config libeigen3-dev libcli11-dev nlohmann-json3-dev libgtest-dev
  libgmock-dev libbenchmark-dev libembree-dev libpng-dev libzip-dev libdw-dev libglfw3-dev libepoxy-dev libimgui-dev)
packages_to_draw=(gnuplot-nox)
packages_for_python=(pybind11-dev python3-dev python3-numpy python3-scipy python3-rtree)
packages_for_ranks=(libopenmpi-dev openmpi-bin libtrilinos-zoltan-dev libhdf5-openmpi-dev)
packages_to_test=(ccache libmpfr-dev xvfb libgl1-mesa-dri fonts-dejavu-core libtbb-dev libbullet-dev python3-numpy abigail-tools
  "${packages_for_ranks[@]}" "${packages_for_python[@]}" python3-pytest python3-matplotlib mypy doxygen python3-venv python3-setuptools python3-wheel)
packages_for_clang=(clang lld libclang-rt-14-dev)
packages_for_coverage=(llvm-14)
packages_for_style=(clang-format clang-tidy)
packages_for_peers=(libbullet-dev libfcl-dev libode-dev libnanoflann-dev)
packages_for_cgal=(libcgal-dev libtbb-dev)
packages_for_blade=(g++-powerpc64-linux-gnu qemu-user googletest)
packages_for_aarch64=(g++-aarch64-linux-gnu qemu-user googletest)
packages_for_sdk=(make g++-powerpc64-linux-gnu g++-powerpc-linux-gnu qemu-user)
packages_for_debian=("${packages_for_python[@]}" help2man dpkg-dev file lintian debootstrap)
packages_for_avx512=(bochs bochs-term bochsbios vgabios isolinux syslinux-common genisoimage busybox-static)

. spu_emu/toolchain/apt.sh

say() { printf '%s\n' "$*" >&2; }

explain_other_systems() {
  say "This script installs packages on Debian 12. Elsewhere, install by hand what these packages hold:"
  say "  $*"
  say "that is: a C++20 compiler, CMake 3.25, Ninja, Eigen 3.4, CLI11 2.1, nlohmann-json 3.11, GoogleTest 1.12 and"
  say "Google Benchmark 1.7; for pictures Embree 3 and libpng, for traces libzip, for the window GLFW 3.3, libepoxy and Dear ImGui,"
  say "for figures gnuplot, for the window's tests Xvfb, for those of job systems oneTBB, for the example in Bullet Bullet,"
  say "for Python's side of traces NumPy, to compare the face for C with its description abigail-tools,"
  say "for the module for Python pybind11, Python's headers, pytest, matplotlib, mypy, pip, SciPy and rtree,"
  say "for worlds over several machines MPI, Zoltan and HDF5 for it, for the reference Doxygen,"
  say "for source lines in the debugger of SPU programs libdw."
  say "Then run again with CELLSWEEP_SKIP_PACKAGES=1 in the environment."
}

is_installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed'; }

# install_packages NAME...: does nothing, quickly, when all are there.
install_packages() {
  [ -n "${CELLSWEEP_SKIP_PACKAGES:-}" ] && return 0
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    explain_other_systems "$@"
    return 1
  fi
  local missing=() name
  for name in "$@"; do is_installed "$name" || missing+=("$name"); done
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    say "These Debian packages are missing, and only root can install them:"
    say "  sudo apt-get install ${missing[*]}"
    return 1
  fi
  say "installing ${#missing[@]} packages: ${missing[*]}"
  packages_are_new=1
  patient_apt_get update -qq &&
    DEBIAN_FRONTEND=noninteractive patient_apt_get install -y -qq --no-install-recommends "${missing[@]}"
}

# The file that says that the SPU compiler of spu_emu/toolchain/build is complete.
spu_compiler() {
  echo "${SPU_EMU_TOOLCHAIN_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/cellsweep/spu-elf}/complete"
}

# say_steps PRESET TARGET...: how much there is to build, unless it is done before it is read.
say_steps() {
  local steps
  steps=$(ninja -C "build/$1" -n "${@:2}" | sed -n '$s/^\[[0-9]*\/\([0-9]*\)\].*/\1/p')
  if [ "${steps:-0}" -ge 10 ]; then say "building in build/$1: $steps steps on $(nproc) cores"; fi
}

# What compilers made is kept by ccache, where that is installed, and taken again wherever the same code is compiled, in
# another clone too: no path of this one counts. Headers compiled before would be another file each time.
use_compiler_cache() {
  options_for_cache=()
  command -v ccache >/dev/null || return 0
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
  options_for_cache=(-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)
}

# configure_preset PRESET [OPTION...]
configure_preset() {
  use_compiler_cache
  cmake --preset "$1" "${options_for_cache[@]}" "${@:2}" >&2
}

# build_preset PRESET [TARGET...]: configures once, then builds; says little when there is little to do. Ninja shows how
# far it is where somebody watches.
build_preset() {
  local preset=$1
  shift
  use_compiler_cache
  # Again when packages came later, or the SPU compiler: SPU programs are then built twice.
  if [ ! -f "build/$preset/build.ninja" ] || [ "$(spu_compiler)" -nt "build/$preset/build.ninja" ] ||
    [ -n "${packages_are_new:-}" ]; then
    say "configuring build/$preset"
    configure_preset "$preset" || return 1
  fi
  local quiet=(--quiet)
  [ -t 2 ] && quiet=()
  if [ $# -eq 0 ]; then set -- all; fi
  say_steps "$preset" "$@"
  ninja -C "build/$preset" "${quiet[@]}" "$@" >&2
}
