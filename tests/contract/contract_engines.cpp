#include "contract/contract_engines.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "contract/executors.h"
#include "every_engine.h"

namespace cellsweep::contract {
namespace {

using Maker = ContractEngine::Maker;
/// Makes an engine whose capacity follows from so many bytes.
using SizedMaker = std::function<Result<Broadphase>(std::uint64_t bytes)>;

/// Few kilobytes of pair map: a capacity that a random sequence runs into all the time.
constexpr std::uint64_t kSmallPairMap = 16 << 10;

/// The smallest local store, in steps of 4 KiB, that holds the 16 bodies of the fixed scenes.
Maker with_small_local_store(const SizedMaker& make) {
  constexpr std::uint64_t kStep = 4096;
  constexpr std::uint64_t kBodies = 16;
  constexpr std::uint64_t kLargest = std::uint64_t{1} << 20;
  for (std::uint64_t bytes = kStep; bytes < kLargest; bytes += kStep) {
    const Result<Broadphase> made = make(bytes);
    if (made && made->capacity().bodies >= kBodies) return [make, bytes] { return make(bytes); };
  }
  throw std::runtime_error("an engine does not hold the bodies of the fixed scenes in any local store");
}

/// An engine by its options struct.
template <class Options>
ContractEngine engine_with_options(std::string name, const Options& options, std::string label) {
  ContractEngine engine{std::move(name), [options] { return make_broadphase(options); }, std::move(label)};
  if constexpr (requires { options.literal; }) {
    if (options.literal) throw std::invalid_argument(engine.label + " would not be exact");
  }
  if constexpr (requires { options.spu_boxes; }) engine.takes_poses = options.spu_boxes;
  if constexpr (requires { options.spes.local_store; }) {
    engine.shrink = [options] {
      return with_small_local_store([sized = options](std::uint64_t bytes) mutable {
        sized.spes.local_store = bytes;
        return make_broadphase(sized);
      });
    };
  } else if constexpr (requires { options.pair_map_bytes; }) {
    engine.shrink = [sized = options]() mutable -> Maker {
      sized.pair_map_bytes = kSmallPairMap;
      return [sized] { return make_broadphase(sized); };
    };
  }
  return engine;
}

#ifdef CELLSWEEP_HAS_CELL

/// Transfers that land late, in an order of their own for each seed.
SpeOptions late_dma(std::uint64_t seed) {
  return {.dma = DmaMode::late, .dma_seed = seed};
}

/// Transfers that land late, in the orders of several seeds, and every way of the Cell engines' results home.
void add_cell_options(std::vector<ContractEngine>& engines) {
  const auto add = [&](const char* name, const auto& options, const char* label) {
    engines.push_back(engine_with_options(name, options, label));
  };
  add("cell-paper", CellPaperOptions{.spes = late_dma(11)}, "cell_paper_with_late_dma");
#if !defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  // What these change is the work of one SPU: for the thread sanitizer the others have the same threads.
  add("cell-paper", CellPaperOptions{.spes = late_dma(12), .list_dma = true},
      "cell_paper_with_late_dma_lists");
  add("cell-paper", CellPaperOptions{.method = 2}, "cell_paper_with_method_2");
#endif
  add("cell-paper", CellPaperOptions{.spes = late_dma(13), .method = 2, .list_dma = true},
      "cell_paper_with_method_2_and_late_dma_lists");
  add("cell-brute", CellBruteOptions{.spes = late_dma(14), .spus = 5},
      "cell_brute_with_late_dma_and_five_spus");
  add("cell-resident", CellResidentOptions{.spes = late_dma(11)}, "cell_resident_with_late_dma");
#if !defined(CELLSWEEP_SANITIZED_TESTS)
  add("cell-stream", CellStreamOptions{.spes = late_dma(11), .spus = 2},
      "cell_stream_with_late_dma_and_two_spus");
#endif
  add("cell-resident", CellResidentOptions{.spes = late_dma(14), .spus = 5, .spu_boxes = true},
      "cell_resident_with_late_dma_five_spus_and_spu_boxes");
}

/// The programs as a real SPU would run them; sanitizers watch the engine itself elsewhere, in its own tests,
/// and in an emulator of another processor there are no other programs.
void add_isa_engines([[maybe_unused]] std::vector<ContractEngine>& engines) {
#if !defined(CELLSWEEP_SANITIZED_TESTS) && !defined(CELLSWEEP_EMULATED_TESTS)
  const auto add = [&](const char* name, const auto& options, const char* label) {
    engines.push_back(engine_with_options(name, options, label));
  };
  const SpeOptions isa{.spe_engine = SpeEngine::isa};
  if (!make_broadphase(CellPaperOptions{.spes = isa})) return;  // built without the SPU compiler
  SpeOptions late = late_dma(21);
  late.spe_engine = SpeEngine::isa;
  add("cell-paper", CellPaperOptions{.spes = late}, "cell_paper_on_isa_with_late_dma");
  add("cell-brute", CellBruteOptions{.spes = isa}, "cell_brute_on_isa");
  add("cell-resident", CellResidentOptions{.spes = isa}, "cell_resident_on_isa");
  add("cell-stream", CellStreamOptions{.spes = isa, .spus = 1}, "cell_stream_on_isa");
  add("cell-resident", CellResidentOptions{.spes = late, .spus = 5, .spu_boxes = true},
      "cell_resident_on_isa_with_late_dma_five_spus_and_spu_boxes");
#endif
}

#else

void add_cell_options(std::vector<ContractEngine>&) {}
void add_isa_engines(std::vector<ContractEngine>&) {}

#endif

/// One job system for all broadphases of a row, as a program would have it.
[[maybe_unused]] void add_executor(std::vector<ContractEngine>& engines, std::shared_ptr<Executor> executor,
                                   const char* label) {
  const StreamOptions options{.threads = kConcurrency, .executor = std::move(executor)};
  engines.push_back(engine_with_options("stream", options, label));
}

/// Engines that never have a second thread.
[[maybe_unused]] void add_engines_of_one_thread(std::vector<ContractEngine>& engines) {
  engines.push_back(engine_with_options("control", ControlOptions{.pair_map_bytes = kSmallPairMap},
                                        "control_with_a_small_pair_map"));
  engines.push_back(engine_with_options("stream", StreamOptions{.threads = 1, .isa = VectorIsa::portable},
                                        "stream_with_one_thread_and_portable_kernels"));
  add_executor(engines, std::make_shared<SequentialExecutor>(), "stream_with_a_sequential_executor");
}

std::vector<ContractEngine> list_engines() {
  std::vector<ContractEngine> engines;
  for (const EngineInfo& info : every_engine()) {
    if (!takes_part(info.name)) continue;
    engines.push_back(engine_with_settings(std::string(info.name), {}, label_of(info.name)));
  }
#if !defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  add_engines_of_one_thread(engines);
#endif
#if !defined(CELLSWEEP_SANITIZED_TESTS)
  // Under sanitizers the determinism contract and the engine's own tests have threads enough.
  // With a margin small worlds have fat boxes, whatever bodies do.
  engines.push_back(engine_with_options("stream", StreamOptions{.threads = 3, .margin = 1e-3F},
                                        "stream_with_three_threads_and_a_margin"));
#endif
#if defined(CELLSWEEP_HAS_TBB) && !defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  // The thread sanitizer does not see how TBB's threads wait for each other.
  add_executor(engines, make_tbb_executor(), "stream_with_a_tbb_executor");
#endif
  add_cell_options(engines);
  add_isa_engines(engines);
  return engines;
}

}  // namespace

const std::vector<ContractEngine>& contract_engines() {
  static const std::vector<ContractEngine> engines = list_engines();
  return engines;
}

bool takes_part([[maybe_unused]] std::string_view name) {
#if defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  return name != "control" && name != "oracle";
#else
  return true;
#endif
}

bool is_interpreted(const ContractEngine& engine) {
  return engine.label.find("_on_isa") != std::string::npos;
}

std::string label_of(std::string_view name) {
  std::string label(name);
  std::replace_if(
      label.begin(), label.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return label;
}

bool has_setting(const EngineInfo& info, std::string_view setting) {
  return std::ranges::any_of(info.settings, [&](const SettingInfo& has) { return has.name == setting; });
}

ContractEngine engine_with_settings(const std::string& name, const SettingValues& settings,
                                    std::string label) {
  const auto with = [name, settings](const char* setting, std::uint64_t value) {
    SettingValues more = settings;
    more.emplace_back(setting, std::to_string(value));
    return make_broadphase(name, more);
  };
  ContractEngine engine{name, [name, settings] { return make_broadphase(name, settings); }, std::move(label)};
  const EngineInfo* info = find_engine(name);
  if (info == nullptr) throw std::invalid_argument("no engine is called " + name);
  if (has_setting(*info, "local_store")) {
    engine.shrink = [with] {
      return with_small_local_store([with](std::uint64_t bytes) { return with("local_store", bytes); });
    };
  } else if (has_setting(*info, "pair_map_bytes")) {
    engine.shrink = [with]() -> Maker { return [with] { return with("pair_map_bytes", kSmallPairMap); }; };
  }
  return engine;
}

Broadphase make(const ContractEngine& engine) {
  Result<Broadphase> made = engine.make();
  if (!made) throw std::runtime_error(engine.label + ": " + made.status().message);
  return std::move(*made);
}

std::ostream& operator<<(std::ostream& out, const ContractEngine& engine) {
  return out << engine.label;
}

}  // namespace cellsweep::contract
