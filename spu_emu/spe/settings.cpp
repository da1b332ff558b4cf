#include "spe/settings.h"

#include <mutex>
#include <stdexcept>

#include "mfc/command.h"

namespace spu_emu {

namespace {
struct Defaults {
  std::mutex mutex;
  EmulationSettings settings;
};

Defaults& defaults() {
  static Defaults instance;
  return instance;
}

thread_local const EmulationSettings* innermost = nullptr;

void check_cycle_parameters(CycleParameters parameters) {
  for (const CycleParameter& each : cycle_parameters()) {
    set_cycle_parameter(parameters, each.name, cycle_parameter(parameters, each.name));
  }
}

void check(const EmulationSettings& settings) {
  if (settings.local_store_limit % kLineSize != 0 || settings.stack_reserve % kLineSize != 0) {
    throw std::invalid_argument("local store limit and stack reserve must be multiples of 128 bytes");
  }
  const std::uint64_t reserves = std::uint64_t{settings.code_reserve} + settings.stack_reserve;
  if (settings.local_store_limit != 0 && reserves > settings.local_store_limit) {
    throw std::invalid_argument("code and stack reserve exceed the local store limit");
  }
  if (!(settings.timebase_hertz > 0)) throw std::invalid_argument("the timebase must be above 0 Hz");
  if (settings.time_limit < settings.time_limit.zero() ||
      settings.time_limit > std::chrono::hours(365 * 24)) {
    throw std::invalid_argument("the time limit must be 0 (none) to a year");
  }
  if (settings.cycles) check_cycle_parameters(*settings.cycles);
}
}  // namespace

void set_default_settings(const EmulationSettings& settings) {
  check(settings);
  const std::lock_guard lock(defaults().mutex);
  defaults().settings = settings;
}

EmulationSettings default_settings() {
  const std::lock_guard lock(defaults().mutex);
  return defaults().settings;
}

SettingsScope::SettingsScope(const EmulationSettings& settings) : outer_(innermost), settings_(settings) {
  check(settings);
  innermost = &settings_;
}

SettingsScope::~SettingsScope() {
  innermost = outer_;
}

EmulationSettings current_settings() {
  return innermost != nullptr ? *innermost : default_settings();
}

}  // namespace spu_emu
