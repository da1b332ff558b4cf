#include <algorithm>
#include <utility>

#include "base/text.h"
#include "engines/cell/emulation.h"

namespace cellsweep::cell {
namespace {

constexpr std::uint64_t kLocalStore = 256 * 1024;
// As the emulation counts for code, variables and stack, so that engines hold as many bodies here as there.
constexpr std::uint64_t kCode = 48 * 1024;
constexpr std::uint64_t kData = 4096;
constexpr std::uint64_t kStack = 16 * 1024;

/// SPEs of the machine. The library tells neither what they transferred nor, in words, why one stopped.
class HardwareSpes final : public Emulation {
 public:
  LocalStoreBudget local_store() const override { return {kLocalStore, kCode, kData, kStack}; }
  spe_program_handle_t& image(spe_program_handle_t& program) const override { return program; }
  spe_context_ptr_t create_context(unsigned flags, unsigned) override {
    return spe_context_create(flags, nullptr);
  }
  SpeCounts counts(spe_context_ptr_t) const override { return {}; }
  SpeCycles cycles(spe_context_ptr_t) const override { return {}; }
  std::string fault(spe_context_ptr_t) const override { return {}; }
};

Status refusal(const char* option, const char* why) {
  return Status::bad_option(option, text(option, ": ", why));
}

}  // namespace

SpeCounts& SpeCounts::operator+=(const SpeCounts& more) {
  gets += more.gets;
  puts += more.puts;
  bytes_in += more.bytes_in;
  bytes_out += more.bytes_out;
  list_elements += more.list_elements;
  local_store_high_water = std::max(local_store_high_water, more.local_store_high_water);
  return *this;
}

Result<std::shared_ptr<Emulation>> make_emulation(const SpeOptions& options, const std::string& trace) {
  if (options.spe_engine != SpeEngine::host)
    return refusal("spe_engine", "this machine has SPEs of its own.");
  if (options.dma != DmaMode::eager)
    return refusal("dma", "the SPEs of this machine decide when bytes move.");
  if (options.local_store != kLocalStore)
    return refusal("local_store", "the SPEs of this machine have 256 KB.");
  if (options.cycles) return refusal("cycles", "this machine is a Cell: its clock tells.");
  if (!trace.empty()) return refusal("trace", "the SPEs of this machine keep no timeline.");
  return std::shared_ptr<Emulation>(std::make_shared<HardwareSpes>());
}

}  // namespace cellsweep::cell
