#include "cellsweep/status.h"

#include <algorithm>
#include <utility>

namespace cellsweep {

Status Status::bad_option(std::string setting, std::string message, std::uint64_t number,
                          std::uint64_t limit) {
  Status status;
  status.code = StatusCode::bad_option;
  status.message = std::move(message);
  status.number = number;
  status.limit = limit;
  status.setting = std::move(setting);
  return status;
}

Status Status::over_capacity(std::string message, std::uint64_t number, std::uint64_t limit,
                             std::string setting) {
  Status status = bad_option(std::move(setting), std::move(message), number, limit);
  status.code = StatusCode::capacity;
  return status;
}

Status Status::bad_input(std::string message, std::string setting, std::uint64_t number,
                         std::uint64_t limit) {
  Status status = bad_option(std::move(setting), std::move(message), number, limit);
  status.code = StatusCode::bad_input;
  return status;
}

Status Status::bad_bodies(StatusCode code, std::string message, std::span<const BodyId> all) {
  Status status;
  status.code = code;
  status.message = std::move(message);
  status.number = all.size();
  const auto named = all.first(std::min(all.size(), kMostBodies));
  status.bodies.assign(named.begin(), named.end());
  if (!all.empty()) status.body = all.front();
  return status;
}

Status Status::spe_failed(std::string message, std::uint64_t spe) {
  Status status = bad_option({}, std::move(message), spe);
  status.code = StatusCode::spe_failed;
  return status;
}

}  // namespace cellsweep
