#include "app/engine_flags.h"

namespace cellsweep::app {

void EngineFlags::add_to(CLI::App& command) {
  for (const EngineInfo& info : engine_table()) names_.emplace_back(info.name);
  command.add_option("--engine", names_, "Engines to run, separated by commas")
      ->delimiter(',')
      ->type_name("NAME[,NAME...]")
      ->capture_default_str();
  command
      .add_option("--threads", options_.threads,
                  "Worker threads of engines that have them; 0: the engine chooses")
      ->capture_default_str();
  command.add_flag("--literal", options_.literal,
                   "control: the document's listing to the letter, misses and all (not exact)");
  command
      .add_option("--pair-map-bytes", options_.pair_map_bytes,
                  "control: memory its map of all possible pairs may take, such as 512M")
      ->transform(CLI::AsSizeValue(false))
      ->type_name("SIZE")
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
