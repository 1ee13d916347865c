# Runs PROGRAM in EXSECT_SOURCE_DIR and compares what it prints with the file EXPECTED.
execute_process(COMMAND "${PROGRAM}" WORKING_DIRECTORY "${EXSECT_SOURCE_DIR}" OUTPUT_VARIABLE output
                COMMAND_ERROR_IS_FATAL ANY)
file(READ "${EXPECTED}" expected)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "${PROGRAM} prints\n${output}\nand not\n${expected}")
endif()
