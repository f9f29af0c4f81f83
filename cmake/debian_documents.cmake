# Before CPack packs: what Debian wants under /usr/share/doc of each package, and its documents compressed.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # SOURCE_DATE_EPOCH, where that is set
foreach(part "program homolog" "development libhomolog-dev")
  separate_arguments(part)
  list(GET part 0 component)
  list(GET part 1 name)
  set(share ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share)
  set(doc ${share}/doc/${name})
  set(program_doc ${CPACK_TEMPORARY_DIRECTORY}/program/usr/share/doc/homolog)
  if(NOT EXISTS ${doc}/copyright)
    file(COPY ${program_doc}/copyright DESTINATION ${doc})
  endif()
  file(WRITE ${doc}/changelog "homolog (${CPACK_PACKAGE_VERSION}) unstable; urgency=low

  * What is new is told by CHANGELOG.md.gz of the package homolog.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(GLOB documents ${doc}/changelog ${doc}/*.md ${share}/man/man1/*.1)
  execute_process(COMMAND gzip -9nf ${documents} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
