# The PowerPC half of a Cell in 32 bits, for the libraries of sdk/install. No processor of qemu's in 32 bits has the
# instructions that a Cell takes from 64-bit PowerPC, those for square roots and long conversions.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ppc)
set(CMAKE_CXX_COMPILER powerpc-linux-gnu-g++)
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cell -maltivec -mno-powerpc64 -mno-powerpc-gpopt")
set(CMAKE_FIND_ROOT_PATH /usr/powerpc-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
