# The stages of the toolchain's build, each done once for its key: the hash of what it is made from. Sourced by build.

binutils_flags=(--target=spu-elf --disable-nls --disable-werror --disable-gprof --disable-gprofng --disable-gdb
  --disable-sim --with-system-zlib --disable-initfini-array)
# The SPU has 256 KB, so what ends a program does not bring the demangler and stdio along (libstdcxx-verbose).
gcc_flags=(--target=spu-elf --enable-obsolete --enable-languages=c,c++ --with-newlib --disable-multilib --disable-nls
  --disable-libssp --disable-libquadmath --disable-libgomp --disable-shared --disable-threads --disable-lto
  --disable-werror --enable-checking=release --with-system-zlib --disable-libstdcxx-pch --disable-libstdcxx-verbose)

patched() { (cd "$here" && cat sources.sha256 "patches/$1"/*.patch); }
binutils_key() { { patched binutils && echo "${binutils_flags[@]}" && declare -f stage_binutils; } | hash_of; }
compiler_key() { { binutils_key && patched gcc && echo "${gcc_flags[@]}" && declare -f stage_compiler; } | hash_of; }
runtime_key() { { compiler_key && patched newlib && declare -f stage_runtime; } | hash_of; }
toolchain_key() { { runtime_key && cat "$here"/include/*.h && declare -f stage_install; } | hash_of; }

# unpack PACKAGE FOLDER: the folder gets the package's source, patched, as a whole or not at all.
unpack() {
  local package=$1 folder=$work/source/$2 patch
  [ -d "$folder" ] && return 0
  mkdir -p "$work/source"
  rm -rf "$folder.new" && mkdir "$folder.new"
  tar -C "$folder.new" --strip-components=1 -xf "$work/tarballs/$(tarballs | grep "^$package")"
  if [ -f "$folder.new/gcc-9.3.0-dfsg.tar.xz" ]; then
    tar -C "$folder.new" --strip-components=1 -xf "$folder.new/gcc-9.3.0-dfsg.tar.xz"
  fi
  for patch in "$here/patches/$2"/*.patch; do patch -d "$folder.new" -p1 --fuzz=0 <"$patch"; done
  mv "$folder.new" "$folder"
}

configure_once() {
  if [ -f config.status ] && [ -f Makefile ]; then return 0; fi
  CFLAGS=-O2 CXXFLAGS=-O2 CFLAGS_FOR_TARGET=-O2 CXXFLAGS_FOR_TARGET=-O2 MAKEINFO=true "$@"
}
quiet_make() { make -j "$jobs" MAKEINFO=true "$@"; }

reset_binutils() { rm -rf "$work/source/binutils" "$work/build/binutils" "$work/install"; }
stage_binutils() {
  unpack binutils binutils
  mkdir -p "$work/build/binutils" && cd "$work/build/binutils"
  configure_once "$work/source/binutils/configure" --prefix="$work/install" "${binutils_flags[@]}"
  quiet_make
  quiet_make install
}

reset_compiler() { rm -rf "$work/source/gcc" "$work/build/gcc"; }
stage_compiler() {
  unpack gcc gcc
  # newlib is built in GCC's tree, as a library for the target among the others.
  ln -sfn ../newlib/newlib "$work/source/gcc/newlib"
  ln -sfn ../newlib/libgloss "$work/source/gcc/libgloss"
  unpack newlib newlib
  mkdir -p "$work/build/gcc" && cd "$work/build/gcc"
  PATH=$work/install/bin:$PATH
  configure_once "$work/source/gcc/configure" --prefix="$work/install" "${gcc_flags[@]}"
  quiet_make all-gcc
  # Debian's tarball lacks documentation that would be compared from now on.
  touch gcc/s-tm-texi
  quiet_make install-gcc
}

reset_runtime() { rm -rf "$work/source/newlib" "$work/build/gcc/spu-elf"; }
stage_runtime() {
  unpack newlib newlib
  cd "$work/build/gcc"
  PATH=$work/install/bin:$PATH
  quiet_make all-target
  quiet_make -j 1 install-target
}

# GCC finds all its parts relative to itself, so that the finished tree can be moved to its place.
reset_install() { rm -rf "$prefix.new"; }
stage_install() {
  mkdir -p "$(dirname "$prefix")"
  rm -rf "$prefix.new" "$prefix.old"
  cp -a "$work/install" "$prefix.new"
  rm -rf "$prefix.new/share"
  cp "$here"/include/*.h "$prefix.new/spu-elf/include/"
  # GCC's own tests that run: the engine that executes SPU programs is tested with them.
  mkdir -p "$prefix.new/testsuite/gcc.c-torture" "$prefix.new/testsuite/gcc.target"
  cp -a "$work/source/gcc/gcc/testsuite/gcc.c-torture/execute" "$prefix.new/testsuite/gcc.c-torture/"
  cp -a "$work/source/gcc/gcc/testsuite/gcc.target/spu" "$prefix.new/testsuite/gcc.target/"
  # A few of the executables are scripts, which strip refuses.
  find "$prefix.new"/{bin,spu-elf/bin,libexec} -type f -perm -u+x -exec strip {} + || true
  check_toolchain "$prefix.new"
  toolchain_key >"$prefix.new/complete"
  if [ -e "$prefix" ]; then mv "$prefix" "$prefix.old"; fi
  mv "$prefix.new" "$prefix"
  rm -rf "$prefix.old"
}

build_toolchain() {
  local started=$SECONDS
  install_packages "${packages_of_toolchain[@]}"
  # What these two leave behind may be gone, so they always look.
  rm -f "$work/stamps/"{fetch,install}.done
  stage fetch "$(hash_of <"$here/sources.sha256")"
  stage binutils "$(binutils_key)"
  stage compiler "$(compiler_key)"
  stage runtime "$(runtime_key)"
  stage install "$(toolchain_key)"
  if [ -z "$keep" ]; then
    rm -rf "$work"/{source,build,install,apt} "$work/stamps/"{binutils,compiler,runtime,install}.*
  fi
  say "done in $((SECONDS - started)) s: $prefix ($(du -sm "$prefix" | cut -f 1) MB); tarballs and logs in $work"
}
