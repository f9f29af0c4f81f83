# The Debian package (scripts/build_deb.sh): program, library, headers, manual page and completions in one, with the packages that it needs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the homolog authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Finds every place where one 3D shape, or a part of it, occurs in
another one, whatever its pose, size and tessellation, and carries landmarks,
colours and textures from one to the other. A program, and a C++ library with
its headers.")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# What the program is linked with, in the versions that it needs.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What a program needs that is built with the library (find_package(homolog) looks for all of it).
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libtbb-dev, libassimp-dev, libfmt-dev, zlib1g-dev")
include(CPack)
