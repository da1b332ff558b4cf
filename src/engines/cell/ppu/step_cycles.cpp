#include "engines/cell/ppu/step_cycles.h"

#include <string>
#include <string_view>

namespace cellsweep::cell {
namespace {

enum Step : std::size_t { kSort, kChangeDetection, kCompaction, kOverlap, kDmaWait, kOther };

struct StepOfFunction {
  std::string_view name;
  Step step;
};

constexpr StepOfFunction kFunctions[] = {
    // cell-paper: C5-C8, C9, C10, C11-C13.
    {"sort_axis", kSort},
    {"intervector_sort", kSort},
    {"insert_from", kSort},
    {"intravector_sort", kSort},
    {"order_equal_values", kSort},
    {"keep_copies", kChangeDetection},
    {"detect_changes", kChangeDetection},
    {"compare_changes", kChangeDetection},
    {"compare_changes_literal", kChangeDetection},
    {"mark_all_changed", kChangeDetection},
    {"compact", kCompaction},
    {"reverse_quicksort", kCompaction},
    {"remove_duplicates", kCompaction},
    {"method_1", kOverlap},
    {"method_2", kOverlap},
    {"build_place_table", kOverlap},
    {"walk_overlaps", kOverlap},
    {"walk_overlaps_literal", kOverlap},
    {"test_all", kOverlap},
    {"KeyStream", kOverlap},
    {"~KeyStream", kOverlap},
    {"send", kOverlap},
    {"send_by_list", kOverlap},
    {"finish", kOverlap},
    // cell-resident: changed bodies are listed in the axis' order and take their places on it; marks tell
    // them from others.
    {"list_by_place", kSort},
    {"list_by_key", kSort},
    {"sort_list", kSort},
    {"sort_network", kSort},
    {"insert_marked", kSort},
    {"merge_bodies", kSort},
    {"move_marked", kSort},
    {"move_body", kSort},
    {"refresh_reach", kSort},
    {"mark_old_boxes", kChangeDetection},
    {"box_at", kChangeDetection},
    {"set_tag_at", kChangeDetection},
    {"unmark", kChangeDetection},
    {"remove_marked", kCompaction},
    {"sweep_share", kOverlap},
    {"sweep", kOverlap},
    {"judge", kOverlap},
    // cell-brute.
    {"overlap_row", kOverlap},
};

/// "type space::(anonymous namespace)::name<arguments>(parameters)" as the name alone.
std::string_view plain_name(std::string_view name) {
  constexpr std::string_view kUnnamed = "(anonymous namespace)::";
  name = name.substr(0, name.find('<'));
  if (const auto unnamed = name.find(kUnnamed); unnamed != std::string_view::npos) {
    name.remove_prefix(unnamed + kUnnamed.size());
  }
  name = name.substr(0, name.find('('));
  const auto space = name.rfind("::");
  return space == std::string_view::npos ? name : name.substr(space + 2);
}

Step step_of(std::string_view function) {
  const std::string_view name = plain_name(function);
  for (const StepOfFunction& each : kFunctions) {
    if (each.name == name) return each.step;
  }
  return kOther;
}

}  // namespace

StepCycles cycles_by_step(std::span<const FunctionCycles> functions) {
  StepCycles steps{};
  for (const FunctionCycles& each : functions) {
    steps[step_of(each.name)] += each.cycles - each.dma_wait;
    steps[kDmaWait] += each.dma_wait;
  }
  return steps;
}

SpeTime spe_time(const StepCycles& now, const StepCycles& before, double hertz) {
  const auto microseconds = [&](Step step) {
    const std::uint64_t earlier = before[step] > now[step] ? 0 : before[step];
    return static_cast<double>(now[step] - earlier) / hertz * 1e6;
  };
  return {microseconds(kSort),    microseconds(kChangeDetection), microseconds(kCompaction),
          microseconds(kOverlap), microseconds(kDmaWait),         microseconds(kOther)};
}

}  // namespace cellsweep::cell
