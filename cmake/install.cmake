# cmake --install BUILD --prefix PREFIX: programs, scripts, cases and pages that work from any folder.
# PREFIX/share/adit is laid out as the source tree, so that scripts, cases and studies find each other alike; the
# scripts find the programs in PREFIX/bin, and the coupler finds its servers beside itself.
install(TARGETS coupler fdm_server dem_server simplified DESTINATION bin)

install(PROGRAMS scripts/adit scripts/run scripts/plot scripts/report scripts/calibrate scripts/trade DESTINATION share/adit/scripts)
install(FILES scripts/adit_programs.py DESTINATION share/adit/scripts)
install(DIRECTORY scripts/adit_plots scripts/adit_report scripts/adit_studies scripts/adit_trade DESTINATION share/adit/scripts
  USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(DIRECTORY cases DESTINATION share/adit USE_SOURCE_PERMISSIONS)
install(DIRECTORY protocol/messages DESTINATION share/adit/protocol FILES_MATCHING PATTERN "*.proto")

file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.md)
install(FILES ${pages} LICENSE DESTINATION share/doc/adit)
install(DIRECTORY docs DESTINATION share/doc/adit)

# install_link(NAME TARGET FOLDER): a symbolic link FOLDER/NAME to TARGET.
function(install_link name target folder)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/links)
  file(CREATE_LINK ${target} ${PROJECT_BINARY_DIR}/links/${name} SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/links/${name} DESTINATION ${folder})
endfunction()
install_link(adit ../share/adit/scripts/adit bin)
install_link(cases ../../adit/cases share/doc/adit)  # where the pages refer to them
install_link(protocol ../../adit/protocol share/doc/adit)
