# Run by CPack on what was installed, before the packages are made of it: what Debian's policy asks for
# and what nobody wants elsewhere.
cmake_policy(VERSION 3.25)
file(GLOB_RECURSE archives "${CPACK_TEMPORARY_DIRECTORY}/*.a")
foreach(archive ${archives})
  execute_process(COMMAND ${CPACK_ROCINANTE_STRIP} --strip-debug --enable-deterministic-archives ${archive} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
# Its terms are said once.
file(GLOB_RECURSE licenses "${CPACK_TEMPORARY_DIRECTORY}/*/LICENSE")
foreach(license ${licenses})
  file(REMOVE ${license})
  file(CREATE_LINK copyright ${license} SYMBOLIC)
endforeach()
file(GLOB_RECURSE changelogs "${CPACK_TEMPORARY_DIRECTORY}/*/changelog.Debian")
foreach(changelog ${changelogs})
  execute_process(COMMAND gzip -9nf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
