# The VTK test reads its files back with VTK itself, by the system's Python (python3-vtk9).
adit_test(results_tests vtk_test.cpp csv_test.cpp summary_test.cpp LIBS adit_results)
target_compile_definitions(results_tests PRIVATE
  ADIT_READ_BACK="/usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/read_back.py")
