#include "protocol/machine/refusal.hpp"

#include <boost/system/system_error.hpp>
#include <cerrno>
#include <filesystem>
#include <new>
#include <system_error>

namespace adit::protocol {
namespace {

std::error_code code_of(const std::exception& error) {
  if (const auto* of_standard = dynamic_cast<const std::system_error*>(&error)) return of_standard->code();
  if (const auto* of_boost = dynamic_cast<const boost::system::system_error*>(&error))
    return of_boost->code();
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return std::make_error_code(std::errc::not_enough_memory);
  return {};
}

}  // namespace

std::optional<Refusal> refusal_of(const std::exception& error) {
  const std::error_code code = code_of(error);
  const std::string what = error.what();
  if (code == std::errc::not_enough_memory)
    return Refusal{kUserError,
                   "there is not enough memory; make the model smaller, or raise the limit (ulimit -v)"};
  if (code == std::errc::too_many_files_open || code == std::errc::too_many_files_open_in_system)
    return Refusal{kUserError, what + "; raise the limit of open files and connections (ulimit -n)"};
  if (code == std::errc::resource_unavailable_try_again)
    return Refusal{kUserError, what + "; raise the limit of threads and processes (ulimit -u)"};
  if (code == std::errc::no_space_on_device || code.value() == EDQUOT)
    return Refusal{kDiskFull, what + "; make room"};
  if (dynamic_cast<const std::filesystem::filesystem_error*>(&error) != nullptr)
    return Refusal{kUserError, what};
  return std::nullopt;
}

}  // namespace adit::protocol
