# Installs the project into a fresh prefix, then configures, builds and runs a program that knows
# nothing but that prefix. Every compiler flag is the build's own, so that sanitizers agree.
# Usage: cmake -D BUILD= -D CONFIGURATION= -D GENERATOR= -D COMPILER= -D LAUNCHER= -D FLAGS= -D WORK=
#              -P consumer.cmake
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# Moved, so that no path of the first prefix can have stuck.
file(RENAME ${WORK}/prefix ${WORK}/moved)
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/build -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${WORK}/moved -D CMAKE_BUILD_TYPE=${CONFIGURATION}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D CMAKE_CXX_FLAGS=${FLAGS}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/consumer ${WORK}/solution.txt COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${WORK})
