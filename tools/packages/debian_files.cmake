# Run by CPack when the files of all packages lie in their folders, before they are packed: what Debian
# asks of each package besides. Its copyright, its changes, man pages compressed, of static libraries
# only what a linker reads, and programs without search paths, since the loader knows /usr/lib.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH sets it
set(project_root ${CMAKE_CURRENT_LIST_DIR}/../..)

# compress(FILES...): with neither name nor time inside, so that the same build gives the same bytes.
function(compress)
  execute_process(COMMAND gzip -9nf ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB folders ${CPACK_TEMPORARY_DIRECTORY}/*)
foreach(folder IN LISTS folders)
  cmake_path(GET folder FILENAME component)
  string(TOUPPER ${component} key)
  set(documents ${folder}/usr/share/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME})

  configure_file(${project_root}/LICENSE ${documents}/copyright COPYONLY)
  configure_file(${project_root}/CHANGELOG.md ${documents}/changelog COPYONLY)
  file(WRITE ${documents}/changelog.Debian
    "${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=low\n\n"
    "  * The changes of the project are in changelog.gz.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  file(GLOB_RECURSE pages ${folder}/usr/share/man/*.[1-9])
  compress(${documents}/changelog ${documents}/changelog.Debian ${pages})

  file(GLOB_RECURSE programs ${folder}/usr/bin/* ${folder}/usr/lib/*.so ${folder}/usr/lib/*.so.*)
  foreach(program IN LISTS programs)
    if(NOT IS_SYMLINK ${program})
      execute_process(COMMAND chrpath --delete ${program} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    endif()
  endforeach()

  file(GLOB_RECURSE archives ${folder}/usr/*.a)
  foreach(archive IN LISTS archives)
    execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note
      --enable-deterministic-archives ${archive} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endforeach()
