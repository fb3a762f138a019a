#include "protocol/scene/program.hpp"

#include <iostream>

#include "protocol/scene/attached_files.hpp"

namespace adit::protocol {
namespace {

int complain(const std::string& message, ExitCode code) {
  std::cerr << message << std::endl;
  return code;
}

}  // namespace

int with_scene(const std::string& path, const std::vector<std::string>& sets,
               const std::function<void(const SceneFile&)>& work) {
  SceneFile file;
  try {
    file = read_scene(path, parse_overrides(sets));
    for (const std::string& warning : file.warnings) std::cerr << "warning: " << warning << std::endl;
    attach_files(file);
    work(file);
    return kSuccess;
  } catch (const UserError& error) {
    return complain("error: " + describe(file, error), kUserError);
  } catch (const PeerLost& error) {
    return complain(std::string("error: ") + error.what(), kPeerLost);
  } catch (const Unstable& error) {
    return complain("error: " + path + ": " + error.what(), kUnstable);
  } catch (const std::exception& error) {
    return complain(std::string("internal error: ") + error.what(), kInternalError);
  }
}

}  // namespace adit::protocol
