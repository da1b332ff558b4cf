#include "app/engine_flags.h"

#include <map>

namespace cellsweep::app {

void EngineFlags::add_to(CLI::App& command, std::string only) {
  if (only.empty()) {
    for (const EngineInfo& info : engine_table()) names_.emplace_back(info.name);
  } else {
    names_.push_back(std::move(only));
  }
  command.add_option("--engine", names_, "Engines to run, separated by commas")
      ->delimiter(',')
      ->type_name("NAME[,NAME...]")
      ->capture_default_str();
  command
      .add_option("--threads", options_.threads,
                  "Worker threads of engines that have them; 0: the engine chooses")
      ->capture_default_str();
  static const std::map<std::string, VectorIsa> kIsas = {{"best", VectorIsa::best},
                                                         {"portable", VectorIsa::portable},
                                                         {"sse4.1", VectorIsa::sse41},
                                                         {"avx2", VectorIsa::avx2},
                                                         {"avx512", VectorIsa::avx512}};
  command
      .add_option("--isa", options_.isa,
                  "stream: instruction set of its kernels: best, portable, sse4.1, avx2 or avx512")
      ->transform(CLI::CheckedTransformer(kIsas, CLI::ignore_case).description(""))
      ->type_name("NAME")
      ->default_str("best");
  command
      .add_option("--max-pairs", options_.max_pairs,
                  "stream: an update that finds more pairs is refused; 0: no limit")
      ->capture_default_str();
  command.add_flag("--on-spes", options_.on_spes,
                   "stream: its cells go through the local stores of SPEs; flags of the Cell engines hold");
  command.add_flag("--literal", options_.literal,
                   "control, cell-paper: the document's logic to the letter, misses and all (not exact)");
  command
      .add_option("--pair-map-bytes", options_.pair_map_bytes,
                  "control, cell-paper: memory its map of all possible pairs may take, such as 512M")
      ->transform(CLI::AsSizeValue(false))
      ->type_name("SIZE")
      ->capture_default_str();
  add_cell_flags(command);
}

void EngineFlags::add_cell_flags(CLI::App& command) {
  static const std::map<std::string, DmaMode> kModes = {
      {"eager", DmaMode::eager}, {"late", DmaMode::late}, {"unchecked", DmaMode::unchecked}};
  static const std::map<std::string, SpeEngine> kSpeEngines = {{"host", SpeEngine::host},
                                                               {"isa", SpeEngine::isa}};
  command.add_option("--method", options_.method, "cell-paper: the document's overlap test, 1 or 2")
      ->capture_default_str();
  command.add_option("--spus", options_.spus, "Cell engines: SPUs that work; 0: the engine chooses")
      ->capture_default_str();
  command
      .add_option("--local-store", options_.local_store_bytes,
                  "Cell engines: local store of an SPE, such as 128K, or off")
      ->transform(CLI::AsSizeValue(false).description(""))
      ->transform(CLI::Transformer(std::map<std::string, std::string>{{"off", "0"}}).description(""))
      ->type_name("SIZE|off")
      ->capture_default_str();
  command
      .add_option(
          "--spe-engine", options_.spe_engine,
          "Cell engines: SPU programs compiled for this machine (host), or for a real SPU and executed\n"
          "instruction by instruction (isa)")
      ->transform(CLI::CheckedTransformer(kSpeEngines, CLI::ignore_case).description(""))
      ->type_name("host|isa")
      ->default_str("host");
  command.add_option("--dma", options_.dma, "Cell engines: when transfers move: eager, late or unchecked")
      ->transform(CLI::CheckedTransformer(kModes, CLI::ignore_case).description(""))
      ->type_name("MODE")
      ->default_str("eager");
  command.add_option("--dma-seed", options_.dma_seed, "Cell engines: the order of late transfers")
      ->capture_default_str();
  command.add_flag("--list-dma", options_.list_dma, "cell-paper: results by DMA list, not in chunks");
  command.add_flag("--spu-boxes", options_.spu_boxes,
                   "cell-resident: given poses, it makes their boxes on the SPUs");
  command
      .add_option("--trace", options_.trace_file,
                  "Write a timeline that opens in Perfetto: phases, and SPEs with their transfers and waits")
      ->type_name("FILE");
}

void EngineFlags::add_cycle_flags(CLI::App& command) {
  command.add_flag("--cycles", options_.cycles,
                   "Cell engines with --spe-engine isa: what the SPEs would take on a Cell, step by step");
  command
      .add_option("--cycle-parameter", options_.cycle_parameters,
                  "With --cycles: change a number of the model; spu-run --list-cycle-parameters names them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  command
      .add_option("--ppu-factor", ppu_costs_.factor,
                  "With --cycles: what takes 1 here takes so much on a Cell's PPU (assumed)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("FACTOR")
      ->capture_default_str();
  command
      .add_option("--spu-start-us", ppu_costs_.spu_start_us,
                  "With --cycles: microseconds to start a frame's SPE threads (the document's static floor)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("MICROSECONDS")
      ->capture_default_str();
}

Result<Engines> EngineFlags::make() const {
  Engines engines;
  for (const std::string& name : names_) {
    auto engine = make_engine(name, options_);
    if (!engine) return engine.status();
    engines.push_back(std::move(*engine));
  }
  return engines;
}

}  // namespace cellsweep::app
