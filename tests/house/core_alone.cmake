# Without io the project configures on a machine that has none of the packages of io; and with
# programs or tests, which need io, it says what is wrong.
# Usage: cmake -D SOURCE= -D GENERATOR= -D COMPILER= -D WORK= -P core_alone.cmake
include(${CMAKE_CURRENT_LIST_DIR}/packages_of_io.cmake)
file(REMOVE_RECURSE ${WORK})
set(configure ${CMAKE_COMMAND} --no-warn-unused-cli -S ${SOURCE} -B ${WORK} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D ASV_BUILD_IO=OFF ${without_packages_of_io})

execute_process(COMMAND ${configure} COMMAND_ERROR_IS_FATAL ANY)

foreach(option ASV_BUILD_TOOLS ASV_BUILD_TESTS)
  execute_process(COMMAND ${configure} -D ASV_BUILD_TOOLS=OFF -D ASV_BUILD_TESTS=OFF -D ${option}=ON
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE message)
  if(code EQUAL 0 OR NOT message MATCHES "ASV_BUILD_IO=OFF")
    message(FATAL_ERROR "${option} without io is not refused: ${message}")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK})
