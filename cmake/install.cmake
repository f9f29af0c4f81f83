# Installs library, headers (in their folders), program, and the package that find_package(homolog) finds. Component `program` is what one
# needs to run it, `development` what one needs to build with it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/homolog)
install(TARGETS homolog EXPORT homologTargets COMPONENT development)
install(TARGETS homolog_cli COMPONENT program)
# Some headers stay behind: they show nlohmann's JSON, which a user of the library need not have.
install(DIRECTORY src/homolog TYPE INCLUDE COMPONENT development FILES_MATCHING PATTERN "*.h" PATTERN "json_text.h" EXCLUDE PATTERN "report_mesh.h" EXCLUDE
  PATTERN "glb.h" EXCLUDE PATTERN "gltf_*.h" EXCLUDE PATTERN "read_gltf_materials.h" EXCLUDE PATTERN "read_gltf_rig.h" EXCLUDE
  PATTERN "read_gltf_animations.h" EXCLUDE)
install(EXPORT homologTargets NAMESPACE homolog:: DESTINATION ${package_dir} COMPONENT development)

configure_package_config_file(cmake/homologConfig.cmake.in ${PROJECT_BINARY_DIR}/homologConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/homologConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/homologConfig.cmake ${PROJECT_BINARY_DIR}/homologConfigVersion.cmake DESTINATION ${package_dir}
  COMPONENT development)
