#include "app/engine_flags.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "app/checks.h"
#include "app/output.h"
#include "base/text.h"
#include "report/engine_settings.h"
#include "report/hand_over.h"
#include "report/oracle.h"
#include "report/units.h"

namespace cellsweep::app {
namespace {

constexpr const char* kEngineGroup = "Settings of engines";
constexpr std::string_view kThreads = "threads";
constexpr std::string_view kCycles = "cycles";
constexpr std::string_view kSpeEngine = "spe_engine";
constexpr std::array<std::string_view, 2> kAboutTimes = {kCycles, "cycle_parameter"};

bool is_about_times(const SharedSetting& setting) {
  return std::find(kAboutTimes.begin(), kAboutTimes.end(), setting.info.name) != kAboutTimes.end();
}

std::vector<std::string_view> engines_with(std::string_view setting) {
  std::vector<std::string_view> names;
  for (const EngineInfo& engine : engine_table()) {
    if (report::has_setting(engine, setting)) names.push_back(engine.name);
  }
  return names;
}

Status no_such_setting(std::string_view setting, const std::vector<std::string>& chosen) {
  return Status::bad_option(
      std::string(setting),
      text(flag_of(setting), " is no setting of ", names_text({chosen.begin(), chosen.end()}),
           "; it is one of ", names_text(engines_with(setting)), "."));
}

Status check_cycles(const SettingValues& values) {
  if (report::value_of(values, kCycles) != "true" || report::value_of(values, kSpeEngine) == "isa") return {};
  return Status::bad_option(std::string(kCycles),
                            "--cycles counts what real SPU code does; it needs --spe-engine isa, too.");
}

Status check_threads(const std::string& value) {
  unsigned long long threads = 0;
  const auto read = std::from_chars(value.data(), value.data() + value.size(), threads);
  if (read.ec == std::errc() && threads <= kMostThreads) return {};
  if (read.ec == std::errc::invalid_argument) return {};  // the library's to refuse
  return Status::bad_option(
      std::string(kThreads),
      text("--threads is ", value, "; at most ", report::count_text(kMostThreads), " are started."), threads,
      kMostThreads);
}

// Why an engine that nobody asked for by name is better not run with so many bodies; empty when it may.
std::string reason_to_leave_out(const Broadphase& engine, std::size_t bodies) {
  const Capacity capacity = engine.capacity();
  if (bodies > capacity.bodies)
    return text("it holds ", report::count_text(capacity.bodies), " bodies (", capacity.reason, ")");
  if (engine.name() == report::kOracle && bodies > report::kMostBodiesOfOracle)
    return text("with more than ", report::count_text(report::kMostBodiesOfOracle),
                " bodies a frame takes seconds. --engine ", report::kOracle, " runs it all the same");
  return {};
}

std::string whole_table_text(EngineFlags::Purpose purpose) {
  if (purpose == EngineFlags::Purpose::verdicts) return "all that hold so many bodies, but for the oracle";
  return text("all that hold so many bodies, the oracle up to ",
              report::count_text(report::kMostBodiesOfOracle));
}

}  // namespace

void EngineFlags::add_to(CLI::App& command, Purpose purpose, std::string only) {
  purpose_ = purpose;
  const bool whole_table = only.empty();
  if (!whole_table) names_.push_back(std::move(only));
  command.add_option("--engine", names_, "Engines, separated by commas")
      ->delimiter(',')
      ->type_name("NAME[,NAME...]")
      ->default_str(whole_table ? whole_table_text(purpose) : names_.front());
  for (const SharedSetting& setting : shared_settings()) {
    if (purpose == Purpose::times || !is_about_times(setting)) add_setting(command, setting);
  }
  if (purpose == Purpose::times && !engines_with(kCycles).empty()) add_ppu_flags(command);
}

void EngineFlags::add_setting(CLI::App& command, const SharedSetting& setting) {
  const SettingInfo& info = setting.info;
  const std::string flag = flag_of(info.name);
  const auto take = [this, info](const std::string& typed) {
    values_.emplace_back(info.name, value_from_typed(info, typed));
  };
  if (info.kind == SettingKind::flag) {
    command
        .add_flag_callback(
            flag, [take] { take("true"); }, help_of(setting))
        ->group(kEngineGroup);
    return;
  }
  const auto take_all = [take](const std::vector<std::string>& typed) {
    for (const std::string& one : typed) take(one);
  };
  auto* option = command.add_option_function<std::vector<std::string>>(flag, take_all, help_of(setting));
  option->type_name(value_name(info))->allow_extra_args(false)->group(kEngineGroup);
  if (info.kind == SettingKind::texts) {
    option->take_all();
  } else {
    option->expected(1);
  }
}

void EngineFlags::add_ppu_flags(CLI::App& command) {
  command
      .add_option("--ppu-factor", ppu_costs_.factor,
                  "With --cycles: what takes 1 here takes so much on a Cell's PPU (assumed)")
      ->check(number(0))
      ->type_name("FACTOR")
      ->group(kEngineGroup)
      ->capture_default_str();
  command
      .add_option("--spu-start-us", ppu_costs_.spu_start_us,
                  "With --cycles: microseconds to start a frame's SPE threads (the document's static floor)")
      ->check(number(0))
      ->type_name("MICROSECONDS")
      ->group(kEngineGroup)
      ->capture_default_str();
}

std::vector<std::string> EngineFlags::names() const {
  if (!names_.empty()) return names_;
  std::vector<std::string> all;
  for (const EngineInfo& info : engine_table()) {
    if (purpose_ != Purpose::verdicts || info.name != report::kOracle) all.emplace_back(info.name);
  }
  return all;
}

Status EngineFlags::check() const {
  const std::vector<std::string> chosen = names();
  for (const std::string& name : chosen) {
    if (find_engine(name) == nullptr) return make_broadphase(name).status();
  }
  for (const auto& [setting, value] : values_) {
    const bool anyone_has_it =
        std::any_of(chosen.begin(), chosen.end(), [&, &wanted = setting](const std::string& name) {
          return report::has_setting(*find_engine(name), wanted);
        });
    if (!anyone_has_it) return no_such_setting(setting, chosen);
    if (setting != kThreads) continue;
    if (Status status = check_threads(value); !status.ok()) return status;
  }
  return check_cycles(values_);
}

Result<std::vector<report::FedEngine>> EngineFlags::make(std::size_t bodies) const {
  if (Status status = check(); !status.ok()) return status;
  std::vector<report::FedEngine> engines;
  for (const std::string& name : names()) {
    const SettingValues settings = report::values_for(name, values_);
    auto engine = make_broadphase(name, settings);
    if (!engine) return engine.status();
    const std::string reason = names_.empty() ? reason_to_leave_out(*engine, bodies) : std::string();
    if (reason.empty()) {
      engines.push_back({std::move(*engine), report::shape_of(settings)});
    } else {
      say(text("Engine ", name, " is left out: ", reason, "."));
    }
  }
  return engines;
}

}  // namespace cellsweep::app
