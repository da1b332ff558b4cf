# Writes HEADER with the commit of SOURCE_DIR, "-dirty" behind it when there are changes, "unknown" outside git.
execute_process(
  COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE commit
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
  RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define CELLSWEEP_COMMIT \"${commit}\"\n")
