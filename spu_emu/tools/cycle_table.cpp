#include "tools/cycle_table.h"

#include <algorithm>
#include <numeric>

#include "mfc/format.h"

namespace spu_emu {

namespace {

unsigned long long number(std::uint64_t value) {
  return value;
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Causes that took anything, the largest first.
std::vector<Stall> causes(const CycleCounts& counts) {
  std::vector<Stall> all;
  for (std::size_t i = 0; i < kStalls; ++i) {
    if (counts.stalls[i] != 0) all.push_back(static_cast<Stall>(i));
  }
  std::stable_sort(all.begin(), all.end(),
                   [&](Stall a, Stall b) { return counts.stall(a) > counts.stall(b); });
  return all;
}

std::string total_lines(const CycleProfile& profile, double hertz) {
  const CycleCounts& total = profile.total;
  std::string text = format("cycles           %llu (%.3f us at %.4g GHz)\n", number(total.cycles),
                            static_cast<double>(total.cycles) / hertz * 1e6, hertz / 1e9);
  text += format("instructions     %llu (%.2f cycles each, %.1f %% in pairs)\n", number(total.instructions),
                 total.cpi(), 100 * total.dual_issue_share());
  text += format("DMA              %llu commands, %llu bytes, %llu cycles of waiting\n",
                 number(profile.dma_commands), number(profile.dma_bytes), number(total.dma_wait()));
  for (const Stall cause : causes(total)) {
    text += format("stalled for      %-22s %12llu (%.1f %%)\n", std::string(stall_name(cause)).c_str(),
                   number(total.stall(cause)), percent(total.stall(cause), total.cycles));
  }
  return text;
}

std::string function_line(const FunctionCycles& function, const CycleCounts& total) {
  const CycleCounts& counts = function.counts;
  std::string text = format("%12llu %5.1f %% %6.2f %5.1f %% %10llu  ", number(counts.cycles),
                            percent(counts.cycles, total.cycles), counts.cpi(),
                            100 * counts.dual_issue_share(), number(counts.dma_wait()));
  std::string most = "-";
  if (const auto all = causes(counts); !all.empty()) {
    most = format("%s %.0f %%", std::string(stall_name(all.front())).c_str(),
                  percent(counts.stall(all.front()), counts.cycles));
  }
  return text + format("%-27s %s\n", most.c_str(), function.name.c_str());
}

}  // namespace

std::string cycle_table(const CycleProfile& profile, double hertz) {
  std::vector<FunctionCycles> functions = profile.functions;
  std::stable_sort(functions.begin(), functions.end(), [](const FunctionCycles& a, const FunctionCycles& b) {
    return a.counts.cycles > b.counts.cycles;
  });
  std::string text = total_lines(profile, hertz);
  text += "      cycles   share    CPI  paired   DMA wait  most stalled for            function\n";
  for (const FunctionCycles& function : functions) text += function_line(function, profile.total);
  return text;
}

std::string cycle_parameter_table(const CycleParameters& parameters) {
  std::string text;
  for (const CycleParameter& each : cycle_parameters()) {
    text += format("%-24s %10g  %s\n%37s[%s]\n", std::string(each.name).c_str(),
                   cycle_parameter(parameters, each.name), std::string(each.meaning).c_str(), "",
                   std::string(each.source).c_str());
  }
  return text;
}

}  // namespace spu_emu
