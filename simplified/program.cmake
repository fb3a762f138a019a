# One program for the three models: from a scene to results.
add_library(adit_simplified STATIC
  tunnel.cpp ground.cpp excitation.cpp along_chainage.cpp joint.cpp beam_model.cpp chain_model.cpp differences.cpp response.cpp
  solve_beam.cpp solve_chain.cpp solve_column.cpp results.cpp zoom.cpp run_summary.cpp run.cpp)
target_link_libraries(adit_simplified PUBLIC adit::options adit_scene adit_reader adit_motion adit_results
  adit_column adit_beam adit_chain fmt::fmt)

add_executable(simplified main.cpp benchmark.cpp)
target_link_libraries(simplified PRIVATE adit_simplified)
