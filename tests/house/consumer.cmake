# Installs the project into fresh prefixes, then configures, builds and runs programs that know
# nothing but such a prefix. Every compiler flag is the build's own, so that sanitizers agree.
# Usage: cmake -D BUILD= -D CONFIGURATION= -D GENERATOR= -D COMPILER= -D LAUNCHER= -D FLAGS= -D WORK=
#              -P consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/packages_of_io.cmake)
file(REMOVE_RECURSE ${WORK})

# install(PREFIX [options...])
function(install prefix)
  file(MAKE_DIRECTORY ${WORK})
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first ${ARGN}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  # Moved, so that no path of the first prefix can have stuck.
  file(RENAME ${WORK}/first ${prefix})
endfunction()

# configure(PREFIX FOLDER [options...]): the project of a stranger; sets code.
function(configure prefix folder)
  execute_process(
    COMMAND ${CMAKE_COMMAND} --no-warn-unused-cli -S ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/consumer -B ${folder} -G ${GENERATOR}
      -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=${CONFIGURATION}
      -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
      -D CMAKE_CXX_FLAGS=${FLAGS} ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# run(FOLDER [arguments...]): builds and starts the program of the stranger.
function(run folder)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${folder}/consumer ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The core where nothing else is installed, on a machine that has none of the packages of io.
install(${WORK}/core --component core)
configure(${WORK}/core ${WORK}/core_build -D CORE_ALONE=ON ${without_packages_of_io})
run(${WORK}/core_build)

# All of it, with every header; and the core out of it, again without the packages of io.
install(${WORK}/all)
configure(${WORK}/all ${WORK}/core_of_all_build -D CORE_ALONE=ON ${without_packages_of_io})
configure(${WORK}/all ${WORK}/all_build)
run(${WORK}/all_build ${WORK}/solution.txt)

file(REMOVE_RECURSE ${WORK})
