# Toolchain for the PowerPC half of a Cell: QS20, QS21, QS22 and PS3, 64 bits, big-endian.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR ppc64)

set(CMAKE_C_COMPILER powerpc64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER powerpc64-linux-gnu-g++)
set(CMAKE_C_FLAGS_INIT "-mcpu=cell -maltivec")
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cell -maltivec")
# A blade's C++ library is older than the compiler's.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static-libstdc++ -static-libgcc")

set(target_folder /usr/powerpc64-linux-gnu)
include(${CMAKE_CURRENT_LIST_DIR}/cross.cmake)

# Of qemu's processors with AltiVec this is the oldest whose dcbz clears the 128 bytes that a Cell's does: in user mode
# the 970's clears 32, which the C library does not expect.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-ppc64 -L /usr/powerpc64-linux-gnu)
