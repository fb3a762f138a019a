#include "protocol/server/server_log.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <string_view>

#include "protocol/log/log.hpp"

namespace adit::protocol {
namespace {

class JsonLines : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& into) override {
    const auto level = spdlog::level::to_string_view(message.level);
    const std::string line = json_line(message.time, {level.data(), level.size()},
                                       {message.payload.data(), message.payload.size()});
    into.append(line.data(), line.data() + line.size());
  }
  std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<JsonLines>(); }
};

}  // namespace

void begin_server_log(const std::string& program, const std::string& level, bool json) {
  spdlog::set_default_logger(spdlog::stderr_color_mt(program));
  spdlog::set_level(spdlog::level::from_str(level));
  if (!json) return;
  log_as_json(program);
  spdlog::set_formatter(std::make_unique<JsonLines>());
}

}  // namespace adit::protocol
