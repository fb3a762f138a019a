# Frames, connection, greeting, server: everything between a message and a socket.
add_library(adit_transport STATIC
  address.cpp connection.cpp error_frame.cpp frame.cpp greeting.cpp heartbeat.cpp
  listener.cpp participant.cpp refusal.cpp server.cpp server_main.cpp)
target_link_libraries(adit_transport
  PUBLIC adit::options adit_messages Boost::boost
  PRIVATE adit_scene spdlog::spdlog CLI11::CLI11 Threads::Threads)
if(ADIT_SANITIZE MATCHES thread)
  # Asio's fences are not understood by the sanitizer; its locks, which order everything here, are.
  target_compile_options(adit_transport PUBLIC -Wno-tsan)
endif()
