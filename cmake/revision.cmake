# Writes the definition of revision() (protocol/revision.hpp): cmake -DSOURCE=… -DINTO=revision.cpp -P revision.cmake
execute_process(COMMAND git rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE}
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git status --porcelain --untracked-files=no WORKING_DIRECTORY ${SOURCE}
  OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(commit AND changes)
  string(APPEND commit " and changes")
endif()
file(WRITE ${INTO} "#include \"protocol/revision.hpp\"

namespace adit::protocol {

std::string_view revision() {
  return \"${commit}\";
}

}  // namespace adit::protocol
")
