# cellsweep_kernels(TARGET): engine stream's kernels as sources of the target, each compiled for its own instruction
# set; which one runs is decided at run time.
function(cellsweep_kernels target)
  set(folder ${PROJECT_SOURCE_DIR}/src/engines/stream/kernels)
  target_sources(${target} PRIVATE ${folder}/portable.cpp)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    cellsweep_kernel(${target} ${folder}/sse41.cpp -msse4.1)
    cellsweep_kernel(${target} ${folder}/avx2.cpp -mavx2)
    cellsweep_kernel(${target} ${folder}/avx512.cpp -mavx512f -mavx512bw)
    target_compile_definitions(${target} PRIVATE CELLSWEEP_X86_KERNELS)
  endif()
endfunction()

function(cellsweep_kernel target source)
  target_sources(${target} PRIVATE ${source})
  set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES COMPILE_OPTIONS "${ARGN}")
endfunction()
