adit_test(coupler_tests overlap_test.cpp interpolation_test.cpp multipliers_test.cpp run_directory_test.cpp
  set_up_test.cpp
  LIBS adit_coupler adit_fdm adit_dem adit_transport rapidcheck)
