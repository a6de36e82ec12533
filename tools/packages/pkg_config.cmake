# pkg-config files, one for each component of the CMake package (tools/asv-config.cmake.in):
# `pkg-config --cflags --libs asv-io`.

# asv_pkg_config(COMPONENT DESCRIPTION text LIBRARIES names... [NEEDS components...] [PACKAGES modules...]
# [THREADS]): writes and installs asv-COMPONENT.pc. PACKAGES are others' pkg-config modules that a user
# of the static library links; a shared one brings them along.
function(asv_pkg_config component)
  cmake_parse_arguments(pc "THREADS" "DESCRIPTION" "LIBRARIES;NEEDS;PACKAGES" ${ARGN})
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH pc_to_prefix ${CMAKE_INSTALL_PREFIX}/${folder} ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" pc_to_prefix ${pc_to_prefix})
  string(REPLACE "_" "-" pc_name ${component})

  list(TRANSFORM pc_NEEDS PREPEND asv-)
  if(NOT BUILD_SHARED_LIBS)
    list(APPEND pc_NEEDS ${pc_PACKAGES})
  endif()
  list(JOIN pc_NEEDS " " pc_requires)
  list(TRANSFORM pc_LIBRARIES PREPEND -l)
  if(pc_THREADS)
    list(APPEND pc_LIBRARIES -pthread)
  endif()
  list(JOIN pc_LIBRARIES " " pc_libs)

  configure_file(${PROJECT_SOURCE_DIR}/tools/packages/asv.pc.in asv-${pc_name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/asv-${pc_name}.pc DESTINATION ${folder} COMPONENT ${component})
endfunction()

asv_pkg_config(core DESCRIPTION "planning and validation" LIBRARIES asv_core asv_geometry
  PACKAGES mpfr gmp THREADS)
asv_pkg_config(generate DESCRIPTION "problems made to order" LIBRARIES asv_generate NEEDS core)
asv_pkg_config(benchmark DESCRIPTION "runs of planners over problems" LIBRARIES asv_benchmark NEEDS core)
if(ASV_BUILD_IO)
  asv_pkg_config(io DESCRIPTION "files, pictures and the player" LIBRARIES asv_io NEEDS core
    PACKAGES cairo cairo-pdf cairo-png cairo-svg libpng yaml-0.1)
  asv_pkg_config(io_benchmark DESCRIPTION "tables and files of benchmarks" LIBRARIES asv_io_benchmark
    NEEDS io benchmark PACKAGES sqlite3)
endif()
