find_package(rapidcheck REQUIRED)
adit_test(reader_tests
  attached_files_test.cpp cells_test.cpp interface_operator_test.cpp nearest_name_test.cpp scene_hash_test.cpp
  scene_reader_test.cpp scene_reader_errors_test.cpp scene_reader_garbage_test.cpp scene_rules_test.cpp
  selection_test.cpp stretches_test.cpp team_test.cpp time_function_test.cpp units_test.cpp
  LIBS adit_reader rapidcheck_gtest)
adit_test(shape_tests shape_test.cpp LIBS adit_scene rapidcheck_gtest TRIES 1000)
