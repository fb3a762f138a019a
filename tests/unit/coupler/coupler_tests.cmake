adit_test(coupler_tests ill_posed_test.cpp shape_test.cpp overlap_test.cpp overlap_error_test.cpp shared_energy_test.cpp interpolation_test.cpp multipliers_test.cpp run_directory_test.cpp
  set_up_test.cpp
  LIBS adit_coupler adit_fdm adit_dem adit_transport rapidcheck TRIES 1000)
