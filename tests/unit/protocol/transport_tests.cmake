add_executable(scripted_server scripted_server.cpp)
target_link_libraries(scripted_server PRIVATE adit::options adit_transport)

adit_test(transport_tests connection_test.cpp conversation_test.cpp frame_test.cpp server_test.cpp
  LIBS adit_transport)
target_compile_definitions(transport_tests PRIVATE SCRIPTED_SERVER="$<TARGET_FILE:scripted_server>")
target_link_libraries(transport_tests PRIVATE Boost::filesystem)
add_dependencies(transport_tests scripted_server)
