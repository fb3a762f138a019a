# What a target with precompiled headers needs of GCC: ccache asks for -fpch-preprocess, and GCC 12 forgets that what it has
# precompiled is the system's, and warns of its own std::string and std::vector.
add_library(adit_precompiled INTERFACE)
target_compile_options(adit_precompiled INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds;-Wno-free-nonheap-object>")

# What most sources of the participants and the coupler include.
set(ADIT_PRECOMPILED "${PROJECT_BINARY_DIR}/protocol/messages/wire.pb.h" <fmt/format.h> <algorithm> <functional> <string> <vector>)

# precompile(TARGET): these headers, compiled once for all libraries, serve all sources of this one, but for those with flags of
# their own.
function(precompile target)
  if(target STREQUAL adit_participant)
    target_precompile_headers(${target} PRIVATE ${ADIT_PRECOMPILED})
  else()
    target_precompile_headers(${target} REUSE_FROM adit_participant)
  endif()
  target_link_libraries(${target} PRIVATE adit_precompiled)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_source_file_property(flags ${source} COMPILE_OPTIONS)
    if(flags)
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# compile_quickly(TARGET...): of sources that run once before a computation and bring in the headers of CLI11 and YAML, or of
# GoogleTest, which take a third longer at -O3.
function(compile_quickly)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
endfunction()

# compile_by_room(TARGET): compiles the sources of each folder as one unit, since the headers of protobuf, Eigen and Asio
# take most of the time of a small file. Names in anonymous namespaces are therefore unique within a folder. Sources with
# flags of their own stay units of their own. The presets for developers build file by file (CMAKE_UNITY_BUILD is off).
function(compile_by_room target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_source_file_property(flags ${source} COMPILE_OPTIONS)
    if(NOT flags)
      get_filename_component(room ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "room_${room}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
