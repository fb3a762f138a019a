# From a scene file to a scene.
add_library(adit_reader STATIC
  attached_files.cpp message_reader.cpp quantity.cpp scene_command_line.cpp scene_hash.cpp scene_merge.cpp
  scene_path.cpp scene_program.cpp scene_reader.cpp scene_rules.cpp scene_writer.cpp units.cpp yaml_tree.cpp)
target_link_libraries(adit_reader PUBLIC adit::options adit_scene adit_messages CLI11::CLI11
  PRIVATE yaml-cpp)
