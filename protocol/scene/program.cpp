#include "protocol/scene/program.hpp"

#include "protocol/log/log.hpp"
#include "protocol/machine/refusal.hpp"
#include "protocol/scene/attached_files.hpp"

namespace adit::protocol {
namespace {

int complain(std::string_view before, const std::string& message, int code) {
  tell(Severity::kError, before, message);
  return code;
}

}  // namespace

int with_errors_told(const std::function<int()>& work) {
  try {
    return work();
  } catch (const UserError& error) {
    const std::string where = error.path().empty() ? "" : error.path() + ": ";
    return complain("error: ", where + error.what(), kUserError);
  } catch (const PeerLost& error) {
    return complain("error: ", error.what(), kPeerLost);
  } catch (const Unstable& error) {
    return complain("error: ", error.what(), kUnstable);
  } catch (const DiskFull& error) {
    return complain("error: ", error.what(), kDiskFull);
  } catch (const Stopped& error) {
    return complain("", error.what(), kSignalled + error.signal());
  } catch (const std::exception& error) {
    if (const auto refusal = refusal_of(error)) return complain("error: ", refusal->message, refusal->code);
    return complain("internal error: ", error.what(), kInternalError);
  }
}

int with_scene(const std::string& path, const std::vector<std::string>& sets,
               const std::function<void(const SceneFile&)>& work) {
  return with_errors_told([&] {
    SceneFile file;
    try {
      file = read_scene(path, parse_overrides(sets));
      for (const std::string& warning : file.warnings) tell(Severity::kWarning, "warning: ", warning);
      attach_files(file);
      work(file);
      return kSuccess;
    } catch (const UserError& error) {
      throw UserError("", describe(file, error));
    } catch (const Unstable& error) {
      throw Unstable(path + ": " + error.what());
    }
  });
}

}  // namespace adit::protocol
