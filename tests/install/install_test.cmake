# Installs the build into a fresh folder, then configures, builds and starts a ten-line program that knows nothing but that folder.
# In: BUILD, SOURCE, WORK, VERSION, COMPILER, GENERATOR (a bare machine has no make).
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed (${code}): ${ARGV}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${WORK}/prefix/bin/homolog --version)
foreach(file man/man1/homolog.1 bash-completion/completions/homolog zsh/site-functions/_homolog fish/vendor_completions.d/homolog.fish)
  if(NOT EXISTS ${WORK}/prefix/share/${file})
    message(FATAL_ERROR "share/${file} was not installed")
  endif()
endforeach()
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/consumer -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix -DHOMOLOG_VERSION=${VERSION}
    -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${WORK}/build)
execute_process(COMMAND ${WORK}/build/consumer RESULT_VARIABLE code)
if(NOT code EQUAL 2)
  message(FATAL_ERROR "the consumer does not start (${code})")
endif()
