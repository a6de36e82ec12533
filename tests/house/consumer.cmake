# Installs the project into fresh prefixes, then configures, builds and runs programs that know
# nothing but such a prefix, by CMake and by pkg-config. Every compiler flag is the build's own, so that
# sanitizers agree. With KEEP the last prefix, WORK/all, is left.
# Usage: cmake -D BUILD= -D CONFIGURATION= -D GENERATOR= -D COMPILER= -D LAUNCHER= -D FLAGS= -D WORK=
#              [-D KEEP=ON] -P consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/packages_of_io.cmake)
file(REMOVE_RECURSE ${WORK})

# install(PREFIX [components...]): these, or all there are.
function(install prefix)
  file(MAKE_DIRECTORY ${WORK})
  set(command ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
  foreach(component IN LISTS ARGN)
    execute_process(COMMAND ${command} --component ${component} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  if(NOT ARGN)
    execute_process(COMMAND ${command} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endif()
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

# run_by_pkg_config(PREFIX SOURCE MODULES names... [ARGUMENTS words...]): the same without CMake.
function(run_by_pkg_config prefix source)
  cmake_parse_arguments(arg "" "" "MODULES;ARGUMENTS" ${ARGN})
  file(GLOB pc_folder ${prefix}/lib/pkgconfig ${prefix}/lib/*/pkgconfig)
  set(ENV{PKG_CONFIG_PATH} ${pc_folder})
  execute_process(COMMAND pkg-config --cflags --libs ${arg_MODULES}
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  # The linker and the loader look for shared libraries in the same folder.
  cmake_path(GET pc_folder PARENT_PATH library_folder)
  separate_arguments(flags UNIX_COMMAND "${FLAGS} -std=c++20 -Wl,-rpath,${library_folder}")
  separate_arguments(found UNIX_COMMAND "${found}")
  execute_process(COMMAND ${COMPILER} ${flags} -o ${prefix}_consumer
    ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/consumer/${source} ${found} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${prefix}_consumer ${arg_ARGUMENTS} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The core where nothing else is installed, on a machine that has none of the packages of io.
install(${WORK}/core core core_runtime)
configure(${WORK}/core ${WORK}/core_build -D CORE_ALONE=ON ${without_packages_of_io})
run(${WORK}/core_build)

# All of it, with every header; and the core out of it, again without the packages of io.
install(${WORK}/all)
configure(${WORK}/all ${WORK}/core_of_all_build -D CORE_ALONE=ON ${without_packages_of_io})
configure(${WORK}/all ${WORK}/all_build)
run(${WORK}/all_build ${WORK}/solution.txt)

# By pkg-config, where there is one.
find_program(pkg_config pkg-config)
if(pkg_config)
  run_by_pkg_config(${WORK}/core plan.cpp MODULES asv-core)
  run_by_pkg_config(${WORK}/all files.cpp MODULES asv-io asv-io-benchmark asv-generate
    ARGUMENTS ${WORK}/solution.txt)
endif()

if(NOT KEEP)
  file(REMOVE_RECURSE ${WORK})
endif()
