# cmake --install BUILD --prefix PREFIX: programs, the Python package, cases and pages that work from any folder.
# PREFIX/share/adit is laid out as the source tree, so that the package finds cases, adapters and messages alike
# (python/adit/programs.py); the coupler finds its servers beside itself.
install(TARGETS coupler fdm_server dem_server simplified DESTINATION bin)
install(PROGRAMS cmake/adit DESTINATION bin)
install(DIRECTORY python/adit DESTINATION lib/python3/dist-packages PATTERN __pycache__ EXCLUDE)
install(DIRECTORY cases DESTINATION share/adit USE_SOURCE_PERMISSIONS)
install(DIRECTORY adapters DESTINATION share/adit USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(DIRECTORY protocol/messages DESTINATION share/adit/protocol FILES_MATCHING PATTERN "*.proto")

# A service of systemd for each server.
foreach(server "fdm;continuum solver" "dem;particle solver")
  list(GET server 0 name)
  list(GET server 1 description)
  string(TOUPPER ${name} NAME)
  configure_file(services/adit.service.in services/adit-${name}.service @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/services/adit-${name}.service DESTINATION lib/systemd/system)
endforeach()

file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.md)
install(FILES ${pages} LICENSE CITATION.cff DESTINATION share/doc/adit)
install(DIRECTORY docs DESTINATION share/doc/adit)

# install_link(NAME TARGET FOLDER): a symbolic link FOLDER/NAME to TARGET.
function(install_link name target folder)
  set(links ${PROJECT_BINARY_DIR}/links/${folder})
  file(MAKE_DIRECTORY ${links})
  file(CREATE_LINK ${target} ${links}/${name} SYMBOLIC)
  install(FILES ${links}/${name} DESTINATION ${folder})
endfunction()
install_link(cases ../../adit/cases share/doc/adit)  # where the pages refer to them
install_link(protocol ../../adit/protocol share/doc/adit)
install_link(adapters ../../adit/adapters share/doc/adit)
