# cpack -G DEB, in the build folder: a Debian package of what cmake/install.cmake installs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME adit)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "tunnels in earthquakes, by coupled continuum and particles")
set(CPACK_PACKAGE_CONTACT "Adit developers <adit@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)  # adit_VERSION_ARCHITECTURE.deb
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openssl, python3, python3-numpy, python3-matplotlib, python3-pil, python3-yaml")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION [[
Adit computes in two dimensions how tunnels shake and break in earthquakes. A
continuum solver carries the ground and the tunnel, a bonded-particle solver
carries the places where the lining may crack, and a coupler joins them at
every time step by the bridging-domain method, on one machine or on two.
Simplified models compute the whole tunnel in seconds.

The programs need a processor with AVX2 (x86-64-v3: Intel since Haswell, AMD
since Excavator).]])

# What Debian asks of every package beside the pages.
configure_file(cmake/debian_changelog.in debian/changelog @ONLY)
execute_process(COMMAND gzip -9nkf ${PROJECT_BINARY_DIR}/debian/changelog COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION share/doc/adit)
install(FILES LICENSE DESTINATION share/doc/adit RENAME copyright)

include(CPack)
