#include <spu_emu/emulation.h>

#include <stdexcept>

#include "base/sanitized.h"
#include "base/text.h"
#include "cellsweep/engine/timeline.h"
#include "engines/cell/emulation.h"
#include "engines/cell/spu_elf.h"

namespace cellsweep::cell {
namespace {

/// Variables of a program and of what the compiler links to it; sanitizers make them larger.
constexpr std::uint64_t kDataBytes = 4096;
constexpr std::uint64_t kSanitizerBytes = kIsSanitized ? 64 * 1024 : 0;
constexpr std::uint64_t kLargestLocalStore = std::uint64_t{1} << 30;
constexpr std::uint64_t kRealLocalStore = std::uint64_t{256} << 10;
constexpr std::uint64_t kLine = 128;

/// Stands for as many SPEs as the engine uses.
constexpr std::uint32_t kSharingAsUsed = 0;

spu_emu::DmaMode mode_of(DmaMode mode) {
  switch (mode) {
    case DmaMode::late:
      return spu_emu::DmaMode::late;
    case DmaMode::unchecked:
      return spu_emu::DmaMode::unchecked;
    default:
      return spu_emu::DmaMode::eager;
  }
}

class SpuEmuEmulation final : public Emulation {
 public:
  SpuEmuEmulation(const SpeOptions& options, std::optional<spu_emu::CycleParameters> cycles,
                  std::shared_ptr<Timeline> timeline)
      : limit_(options.local_store),
        isa_(options.spe_engine == SpeEngine::isa),
        timeline_(std::move(timeline)) {
    settings_.dma_mode = mode_of(options.dma);
    settings_.seed = options.dma_seed;
    settings_.local_store_limit =
        static_cast<std::uint32_t>(limit_ == 0 || isa_ ? limit_ : limit_ + kSanitizerBytes);
    settings_.trace = timeline_ != nullptr;
    settings_.cycles = cycles;
  }

  LocalStoreBudget local_store() const override {
    return {limit_, settings_.code_reserve, kDataBytes, settings_.stack_reserve};
  }

  spe_program_handle_t& image(spe_program_handle_t& program) const override {
    return isa_ ? *spu_elf_of(program) : program;
  }

  spe_context_ptr_t create_context(unsigned flags, unsigned spes) override {
    spu_emu::EmulationSettings settings = settings_;
    if (settings.cycles && settings.cycles->sharing_spes == kSharingAsUsed)
      settings.cycles->sharing_spes = spes;
    const spu_emu::SettingsScope scope(settings);
    ++settings_.seed;  // each SPE's transfers land in an order of their own
    return spe_context_create(flags, nullptr);
  }

  SpeCounts counts(spe_context_ptr_t spe) const override {
    const spu_emu::SpeStatistics all = spu_emu::statistics(spe);
    return {all.gets, all.puts, all.bytes_in, all.bytes_out, all.list_elements, all.local_store_high_water};
  }

  SpeCycles cycles(spe_context_ptr_t spe) const override {
    if (!settings_.cycles) return {};
    SpeCycles result{settings_.cycles->hertz, {}};
    for (spu_emu::FunctionCycles& each : spu_emu::cycle_profile(spe).functions) {
      result.functions.push_back({std::move(each.name), each.counts.cycles, each.counts.dma_wait()});
    }
    return result;
  }

  std::string fault(spe_context_ptr_t spe) const override { return spu_emu::last_fault(spe); }

 private:
  std::uint64_t limit_;
  bool isa_;
  spu_emu::EmulationSettings settings_;
  std::shared_ptr<Timeline> timeline_;  // written after the last context is gone
};

Status check_local_store(const SpeOptions& options) {
  const spu_emu::EmulationSettings defaults;
  const std::uint64_t bytes = options.local_store;
  const std::uint64_t least = defaults.code_reserve + kDataBytes + defaults.stack_reserve;
  if (bytes == 0 || (bytes >= least && bytes <= kLargestLocalStore && bytes % kLine == 0)) return {};
  return Status::bad_option(
      "local_store",
      text("local_store is ", bytes, "; it must be a multiple of ", kLine, " from ", least,
           " (code, data and stack) to ", kLargestLocalStore, ", or 0 for no limit."),
      bytes, least);
}

Status check_isa(const SpeOptions& options) {
  if (options.spe_engine != SpeEngine::isa && !has_only_spu_elf()) return {};
  if (!has_spu_elf()) {
    return Status::bad_option("spe_engine",
                              "spe_engine isa: this build has no programs for a real SPU. Build the SPU "
                              "compiler with spu_emu/toolchain/build, then configure again.");
  }
  const std::uint64_t bytes = options.local_store;
  if (bytes != 0 && bytes <= kRealLocalStore) return {};
  return Status::bad_option(
      "local_store",
      text("local_store is ", bytes, bytes == 0 ? " (no limit)" : "", "; a real SPU has ", kRealLocalStore,
           ", and its programs (spe_engine isa) get no more."),
      bytes, kRealLocalStore);
}

Status refusal(const char* setting, const std::string& why) {
  return Status::bad_option(setting, text(setting, ": ", why, "."));
}

/// The cycle model's numbers, if it is wanted.
Result<std::optional<spu_emu::CycleParameters>> find_cycle_parameters(const SpeOptions& options) {
  if (!options.cycles) return std::optional<spu_emu::CycleParameters>();
  if (options.spe_engine != SpeEngine::isa) {
    return refusal("cycles", "only real SPU code has them; ask for spe_engine isa, too");
  }
  spu_emu::CycleParameters parameters;
  parameters.sharing_spes = kSharingAsUsed;
  try {
    for (const std::string& each : options.cycle_parameter) spu_emu::set_cycle_parameter(parameters, each);
  } catch (const std::invalid_argument& error) {
    return refusal("cycle_parameter", error.what());
  }
  return std::optional(parameters);
}

}  // namespace

SpeCounts& SpeCounts::operator+=(const SpeCounts& more) {
  gets += more.gets;
  puts += more.puts;
  bytes_in += more.bytes_in;
  bytes_out += more.bytes_out;
  list_elements += more.list_elements;
  local_store_high_water = local_store_high_water > more.local_store_high_water ? local_store_high_water
                                                                                : more.local_store_high_water;
  return *this;
}

Result<std::shared_ptr<Emulation>> make_emulation(const SpeOptions& options, const std::string& trace) {
  if (Status status = check_local_store(options); !status.ok()) return status;
  if (Status status = check_isa(options); !status.ok()) return status;
  auto cycles = find_cycle_parameters(options);
  if (!cycles) return cycles.status();
  std::shared_ptr<Timeline> timeline;
  if (!trace.empty()) {
    auto opened = Timeline::open(trace);
    if (!opened) return opened.status();
    timeline = std::move(*opened);
    timeline->show_spes(&spu_emu::write_trace_events);
  }
  return std::shared_ptr<Emulation>(std::make_shared<SpuEmuEmulation>(options, *cycles, std::move(timeline)));
}

}  // namespace cellsweep::cell
