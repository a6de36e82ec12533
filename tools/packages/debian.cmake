# Debian packages of what is built, by CPack: tools/package.sh.
#   asv-brooms     the programs, their man pages and completions
#   libasv-dev     headers, libraries to link, CMake and pkg-config files
#   libasv0.2.0    what programs need of shared libraries when they run (BUILD_SHARED_LIBS); each
#                  version has a name of its own, since none keeps the layout of types
#   python3-asv    the Python module (ASV_BUILD_PYTHON)
set(ASV_PACKAGE_CONTACT "The ASV brooms developers <developers@asv-brooms.org>" CACHE STRING
  "Who answers for Debian packages that are made here: NAME <ADDRESS>")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asv-brooms)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT ${ASV_PACKAGE_CONTACT})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_COMPONENTS_ALL)

# asv_debian_package(COMPONENT NAME SECTION section SUMMARY text DESCRIPTION text [DEPENDS packages...]
# [COMPONENTS components...]): one package, of the install components given or of that of its own name.
function(asv_debian_package component name)
  cmake_parse_arguments(arg "" "SECTION;SUMMARY;DESCRIPTION" "DEPENDS;COMPONENTS" ${ARGN})
  if(arg_COMPONENTS)
    foreach(part IN LISTS arg_COMPONENTS)
      string(TOUPPER ${part} part_key)
      set(CPACK_COMPONENT_${part_key}_GROUP ${component} PARENT_SCOPE)
    endforeach()
  else()
    set(arg_COMPONENTS ${component})
  endif()
  list(JOIN arg_DEPENDS ", " depends)
  string(TOUPPER ${component} key)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${arg_COMPONENTS} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${arg_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${arg_SUMMARY}\n${arg_DESCRIPTION}" PARENT_SCOPE)
endfunction()

set(about "ASVs (autonomous surface vehicles) are points in the plane that rigid booms,
the brooms, join to a chain. Planned is how such a chain moves among
rectangles. Every motion is proven valid as a whole.\n\n")

set(parts core generate benchmark)
if(ASV_BUILD_IO)
  list(APPEND parts io io_benchmark)
endif()
set(needed_to_link libmpfr-dev libgmp-dev)
if(ASV_BUILD_IO)
  list(APPEND needed_to_link pkg-config libcairo2-dev libpng-dev libyaml-dev libsqlite3-dev)
endif()

set(needed_to_run)
if(BUILD_SHARED_LIBS)
  set(runtime_package libasv${PROJECT_VERSION})
  # What is made in the same build is unknown to Debian, so its name is given.
  set(needed_to_run "${runtime_package} (= ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
  set(needed_to_link ${needed_to_run})
  list(TRANSFORM parts APPEND _runtime OUTPUT_VARIABLE runtime_parts)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/libraries/triggers)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
  asv_debian_package(runtime ${runtime_package} SECTION libs COMPONENTS ${runtime_parts}
    SUMMARY "planner for chains of ASVs joined by brooms - shared libraries"
    DESCRIPTION "${about}These are what programs need when they run.")
endif()
asv_debian_package(development libasv-dev SECTION libdevel COMPONENTS ${parts} DEPENDS ${needed_to_link}
  SUMMARY "planner for chains of ASVs joined by brooms - development files"
  DESCRIPTION "${about}These are headers, libraries, and the files by which CMake and
pkg-config find them.")
if(ASV_BUILD_TOOLS)
  asv_debian_package(programs asv-brooms SECTION science DEPENDS ${needed_to_run}
    SUMMARY "planner for chains of ASVs joined by brooms - programs"
    DESCRIPTION "${about}These are the programs that solve, validate, draw, generate and compare
problems: asv-solve, asv-validate, asv-view, asv-generate and asv-bench.")
endif()
if(ASV_BUILD_PYTHON)
  # The module is compiled for one minor version of Debian's interpreter.
  execute_process(COMMAND /usr/bin/python3 -c "import sys; print(sys.version_info.minor)"
    OUTPUT_VARIABLE minor OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  # Bytecode is made when the package is installed, and goes when it goes.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
  math(EXPR next_minor "${minor} + 1")
  asv_debian_package(python python3-asv SECTION python
    DEPENDS "python3 (>= 3.${minor})" "python3 (<< 3.${next_minor})" python3-numpy ${needed_to_run}
    SUMMARY "planner for chains of ASVs joined by brooms - Python module"
    DESCRIPTION "${about}This is the Python module asv.")
endif()

include(CPack)
