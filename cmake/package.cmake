# The Debian packages (scripts/build_deb.sh): `homolog`, the program with its manual page and completions, and `libhomolog-dev`, the library
# with its headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the homolog authors <homolog@noreply.invalid>") # there is no address, but a package must name one
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "finds corresponding parts of 3D shapes")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_documents.cmake)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME homolog)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Finds every place where one 3D shape, or a part of it, occurs in
another one, whatever its pose, size and tessellation, and carries landmarks,
colours, textures and rigs from one to the other.")
# What the program is linked with, in the versions that it needs.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS libhomolog-dev)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libhomolog-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Finds every place where one 3D shape, or a part of it, occurs in
another one, whatever its pose, size and tessellation.
.
This package holds the static library, its headers, and what
find_package(homolog) of CMake looks for.")
# What find_package(homolog) looks for again.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libtbb-dev, libassimp-dev, libfmt-dev, zlib1g-dev, libminizip-dev, libexpat1-dev")
include(CPack)
