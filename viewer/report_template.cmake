# Bundles the page of report.html and compiles it into the library, so that the installed program needs no other file.
set(HOMOLOG_REPORT_TEMPLATE "" CACHE FILEPATH "A report_template.cpp made elsewhere by viewer/build.mjs; then npm is not needed")

set(report_template ${HOMOLOG_REPORT_TEMPLATE})
if(NOT report_template)
  find_program(HOMOLOG_NODE NAMES node nodejs)
  find_program(HOMOLOG_NPM npm)
  if(NOT HOMOLOG_NODE OR NOT HOMOLOG_NPM)
    message(FATAL_ERROR "The page of the report is bundled by Node.js and npm, which are not there; scripts/install_dependencies.sh --build-only installs them.")
  endif()
  set(viewer ${CMAKE_CURRENT_SOURCE_DIR}/viewer)
  set(report_template ${CMAKE_CURRENT_BINARY_DIR}/viewer/report_template.cpp)
  file(GLOB viewer_sources CONFIGURE_DEPENDS ${viewer}/src/*)

  # npm writes this file last; touching it tells the build that the packages are those of the lock file.
  set(installed ${viewer}/node_modules/.package-lock.json)
  add_custom_command(OUTPUT ${installed}
    COMMAND ${HOMOLOG_NPM} ci --ignore-scripts --silent
    COMMAND ${CMAKE_COMMAND} -E touch ${installed}
    DEPENDS ${viewer}/package.json ${viewer}/package-lock.json
    WORKING_DIRECTORY ${viewer} COMMENT "Installing the viewer's packages" VERBATIM)
  add_custom_command(OUTPUT ${report_template}
    COMMAND ${HOMOLOG_NODE} build.mjs --cpp ${report_template}
    DEPENDS ${installed} ${viewer}/build.mjs ${viewer_sources}
    WORKING_DIRECTORY ${viewer} COMMENT "Bundling the report's page" VERBATIM)
endif()
target_sources(homolog PRIVATE ${report_template})
