# Installs spu_emu into a fresh folder, builds the package test against it, and runs the program it makes.
# Called with -DBUILD=<build folder of spu_emu> -DSOURCE=<this folder> -DWORK=<scratch folder> -DCOMPILER=<c++>
# -DFLAGS=<flags> -DGENERATOR=<CMake generator> -DTOOLCHAIN=<folder of the SPU compiler, or OFF>.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
  -DSPU_EMU_TOOLCHAIN_DIR=${TOOLCHAIN} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/list_gather late COMMAND_ERROR_IS_FATAL ANY)
if(TOOLCHAIN)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target spu_sizes OUTPUT_VARIABLE sizes
    COMMAND_ERROR_IS_FATAL ANY)
  if(NOT sizes MATCHES "list_gather_spu +[0-9]+")
    message(FATAL_ERROR "spu_sizes of the installed package says: ${sizes}")
  endif()
endif()
