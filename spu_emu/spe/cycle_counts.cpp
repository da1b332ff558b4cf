#include "spu_emu/cycles.h"

namespace spu_emu {

std::string_view stall_name(Stall cause) {
  static constexpr std::string_view kNames[kStalls] = {
      "fixed-point result", "floating-point result",  "shuffle result", "load",
      "channel result",     "after double precision", "branch miss",    "late hint",
      "port busy with DMA", "instruction fetch",      "DMA wait",       "DMA queue full"};
  return kNames[static_cast<std::size_t>(cause)];
}

CycleCounts& CycleCounts::operator+=(const CycleCounts& more) {
  cycles += more.cycles;
  instructions += more.instructions;
  dual_issued += more.dual_issued;
  for (std::size_t i = 0; i < kStalls; ++i) stalls[i] += more.stalls[i];
  return *this;
}

CycleCounts& CycleCounts::operator-=(const CycleCounts& earlier) {
  cycles -= earlier.cycles;
  instructions -= earlier.instructions;
  dual_issued -= earlier.dual_issued;
  for (std::size_t i = 0; i < kStalls; ++i) stalls[i] -= earlier.stalls[i];
  return *this;
}

double CycleCounts::cpi() const {
  return instructions == 0 ? 0 : static_cast<double>(cycles) / static_cast<double>(instructions);
}

double CycleCounts::dual_issue_share() const {
  return instructions == 0 ? 0 : 2.0 * static_cast<double>(dual_issued) / static_cast<double>(instructions);
}

}  // namespace spu_emu
