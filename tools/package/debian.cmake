# Run by cpack before it packs: what Debian wants of a package beyond what is installed anywhere.
# CPACK_TEMPORARY_DIRECTORY has a folder for each component.
function(compress file)
  execute_process(COMMAND gzip -9 --no-name ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(rw-r--r-- OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
set(rwxr-xr-x ${rw-r--r--} OWNER_EXECUTE GROUP_EXECUTE WORLD_EXECUTE)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} COMPONENT)
  set(share ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}/share)
  set(documents ${share}/doc/${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME})
  file(REMOVE ${share}/doc/hearth/LICENSE)
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/changelog DESTINATION ${documents})
  file(COPY_FILE ${CPACK_RESOURCE_FILE_LICENSE} ${documents}/copyright)
  compress(${documents}/changelog)
  if(component STREQUAL program)
    compress(${share}/man/man1/hearth.1)
    file(MAKE_DIRECTORY ${share}/lintian/overrides)
    file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/lintian-overrides ${share}/lintian/overrides/hearth)
  endif()
  # Whatever the umask is that packs, or that cloned the sources.
  file(CHMOD_RECURSE ${share} FILE_PERMISSIONS ${rw-r--r--})
  file(CHMOD_RECURSE ${CPACK_TEMPORARY_DIRECTORY}/${component} DIRECTORY_PERMISSIONS ${rwxr-xr-x})
endforeach()
