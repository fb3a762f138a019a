# cmake --install BUILD --prefix PREFIX: programs, scripts, cases and pages that work from any folder.
# PREFIX/share/adit is laid out as the source tree, so that scripts, cases and studies find each other alike; the
# scripts find the programs in PREFIX/bin, and the coupler finds its servers beside itself.
install(TARGETS coupler fdm_server dem_server simplified DESTINATION bin)

install(PROGRAMS scripts/command scripts/run scripts/plot scripts/report scripts/compare scripts/paraview scripts/calibrate scripts/certificates scripts/cluster scripts/trade scripts/conformance DESTINATION share/adit/scripts)
install(FILES scripts/adit_programs.py DESTINATION share/adit/scripts)
install(DIRECTORY scripts/adit scripts/adit_cluster scripts/adit_compare scripts/adit_conformance scripts/adit_paraview scripts/adit_plots scripts/adit_report scripts/adit_run scripts/adit_studies scripts/adit_trade DESTINATION share/adit/scripts
  USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
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
install(FILES ${pages} LICENSE DESTINATION share/doc/adit)
install(DIRECTORY docs DESTINATION share/doc/adit)

# install_link(NAME TARGET FOLDER): a symbolic link FOLDER/NAME to TARGET.
function(install_link name target folder)
  set(links ${PROJECT_BINARY_DIR}/links/${folder})
  file(MAKE_DIRECTORY ${links})
  file(CREATE_LINK ${target} ${links}/${name} SYMBOLIC)
  install(FILES ${links}/${name} DESTINATION ${folder})
endfunction()
install_link(adit ../share/adit/scripts/command bin)
install_link(adit ../../../share/adit/scripts/adit lib/python3/dist-packages)  # `import adit`
install_link(cases ../../adit/cases share/doc/adit)  # where the pages refer to them
install_link(protocol ../../adit/protocol share/doc/adit)
install_link(adapters ../../adit/adapters share/doc/adit)
