#include "contract/contract_engines.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace cellsweep::contract {
namespace {

/// Few kilobytes of pair map: a capacity that a random sequence runs into all the time.
constexpr std::uint64_t kSmallPairMap = 16 << 10;

std::string label_of(std::string_view name) {
  std::string label(name);
  std::replace_if(
      label.begin(), label.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return label;
}

/// The smallest local store, in steps of 4 KiB, that holds the 16 bodies of the fixed scenes.
EngineOptions small_local_store(const std::string& name, EngineOptions options) {
  constexpr std::uint64_t kStep = 4096;
  constexpr std::uint64_t kBodies = 16;
  constexpr std::uint64_t kLargest = std::uint64_t{1} << 20;
  for (options.local_store_bytes = kStep; options.local_store_bytes < kLargest;
       options.local_store_bytes += kStep) {
    const auto engine = make_engine(name, options);
    if (engine.ok() && (*engine)->capacity().bodies >= kBodies) return options;
  }
  throw std::runtime_error(name + " does not hold the bodies of the fixed scenes in any local store");
}

/// Transfers that land late, in the orders of several seeds, and every way of the Cell engines' results home.
void add_cell_options(std::vector<ContractEngine>& engines) {
  const EngineOptions late{.dma = DmaMode::late, .dma_seed = 11};
  EngineOptions late_list = late;
  late_list.dma_seed = 12;
  late_list.list_dma = true;
  EngineOptions late_method_2 = late_list;
  late_method_2.dma_seed = 13;
  late_method_2.method = 2;
  EngineOptions late_five_spus = late;
  late_five_spus.dma_seed = 14;
  late_five_spus.spus = 5;
  engines.push_back({"cell-paper", late, "cell_paper_with_late_dma"});
#if !defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  // What these change is the work of one SPU: for the thread sanitizer the others have the same threads.
  engines.push_back({"cell-paper", late_list, "cell_paper_with_late_dma_lists"});
  engines.push_back({"cell-paper", {.method = 2}, "cell_paper_with_method_2"});
#endif
  engines.push_back({"cell-paper", late_method_2, "cell_paper_with_method_2_and_late_dma_lists"});
  engines.push_back({"cell-brute", late_five_spus, "cell_brute_with_late_dma_and_five_spus"});
  engines.push_back({"cell-resident", late, "cell_resident_with_late_dma"});
#if !defined(CELLSWEEP_SANITIZED_TESTS)
  EngineOptions stream_late = late;
  stream_late.on_spes = true;
  stream_late.spus = 2;
  engines.push_back({"stream", stream_late, "stream_on_two_spes_with_late_dma"});
#endif
  late_five_spus.spu_boxes = true;
  engines.push_back({"cell-resident", late_five_spus, "cell_resident_with_late_dma_five_spus_and_spu_boxes"});
}

/// The programs as a real SPU would run them; sanitizers watch the engine itself elsewhere, in its own tests,
/// and in an emulator of another processor there are no other programs.
void add_isa_engines([[maybe_unused]] std::vector<ContractEngine>& engines) {
#if !defined(CELLSWEEP_SANITIZED_TESTS) && !defined(CELLSWEEP_EMULATED_TESTS)
  const EngineOptions isa{.spe_engine = SpeEngine::isa};
  if (!make_engine("cell-paper", isa)) return;  // built without the SPU compiler
  EngineOptions late = isa;
  late.dma = DmaMode::late;
  late.dma_seed = 21;
  EngineOptions late_boxes = late;
  late_boxes.spus = 5;
  late_boxes.spu_boxes = true;
  engines.push_back({"cell-paper", late, "cell_paper_on_isa_with_late_dma"});
  engines.push_back({"cell-brute", isa, "cell_brute_on_isa"});
  engines.push_back({"cell-resident", isa, "cell_resident_on_isa"});
  EngineOptions stream_isa = isa;
  stream_isa.on_spes = true;
  stream_isa.spus = 1;
  engines.push_back({"stream", stream_isa, "stream_on_isa"});
  engines.push_back(
      {"cell-resident", late_boxes, "cell_resident_on_isa_with_late_dma_five_spus_and_spu_boxes"});
#endif
}

bool is_in_table(std::string_view name) {
  return std::ranges::any_of(engine_table(), [&](const EngineInfo& info) { return info.name == name; });
}

std::vector<ContractEngine> list_engines() {
  std::vector<ContractEngine> engines;
  for (const EngineInfo& info : engine_table()) {
    engines.push_back({std::string(info.name), {}, label_of(info.name)});
  }
  engines.push_back({"control", {.pair_map_bytes = kSmallPairMap}, "control_with_a_small_pair_map"});
#if !defined(CELLSWEEP_SANITIZED_TESTS)
  // Under sanitizers the determinism contract and the engine's own tests have threads enough.
  engines.push_back({"stream", {.threads = 3}, "stream_with_three_threads"});
#endif
  engines.push_back(
      {"stream", {.threads = 1, .isa = VectorIsa::portable}, "stream_with_one_thread_and_portable_kernels"});
  if (is_in_table("cell-paper")) {
    add_cell_options(engines);
    add_isa_engines(engines);
  }
  return engines;
}

}  // namespace

const std::vector<ContractEngine>& contract_engines() {
  static const std::vector<ContractEngine> engines = list_engines();
  return engines;
}

std::optional<EngineOptions> small_capacity_options(const ContractEngine& engine) {
  if (engine.name.starts_with("cell-")) return small_local_store(engine.name, engine.options);
  if (engine.name != "control") return std::nullopt;
  EngineOptions options = engine.options;
  options.pair_map_bytes = kSmallPairMap;
  return options;
}

std::unique_ptr<Broadphase> make(const ContractEngine& engine) {
  auto made = make_engine(engine.name, engine.options);
  if (!made) throw std::runtime_error(engine.label + ": " + made.status().message);
  return std::move(*made);
}

std::ostream& operator<<(std::ostream& out, const ContractEngine& engine) {
  return out << engine.label;
}

}  // namespace cellsweep::contract
