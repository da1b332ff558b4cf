#include "app/scene_flags.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/checks.h"
#include "base/text.h"

namespace cellsweep::app {
namespace {

constexpr const char* kSceneGroup = "The scene";
constexpr const char* kFilterGroup = "Which bodies meet";

constexpr std::array kGiantSlots = {std::pair{std::string_view("none"), GiantSlot::none},
                                    std::pair{std::string_view("first"), GiantSlot::first},
                                    std::pair{std::string_view("middle"), GiantSlot::middle},
                                    std::pair{std::string_view("last"), GiantSlot::last}};

GiantSlot slot_of(std::string_view word) {
  return std::find_if(kGiantSlots.begin(), kGiantSlots.end(),
                      [&](const auto& one) { return one.first == word; })
      ->second;
}

std::string_view word_of(GiantSlot slot) {
  return std::find_if(kGiantSlots.begin(), kGiantSlots.end(),
                      [&](const auto& one) { return one.second == slot; })
      ->first;
}

std::vector<std::string_view> giant_words() {
  std::vector<std::string_view> words;
  words.reserve(kGiantSlots.size());
  for (const auto& [word, slot] : kGiantSlots) words.push_back(word);
  return words;
}

}  // namespace

void SceneFlags::add_to(CLI::App& command) {
  constexpr std::uint64_t kMostBodies = std::uint64_t{1} << 32;
  constexpr double kTopSpeed = 1e6;
  std::string names;
  for (const SceneInfo& info : scene_table()) names += (names.empty() ? "" : ", ") + std::string(info.name);
  command.add_option("--scene", settings.scene, "Scene: " + names)
      ->type_name("NAME")
      ->group(kSceneGroup)
      ->capture_default_str();
  command.add_option("--bodies", settings.bodies, "Number of bodies")
      ->check(count(0, kMostBodies))
      ->type_name("N")
      ->group(kSceneGroup)
      ->capture_default_str();
  command.add_option("--moving", settings.moving, "Share of the bodies that move, 0 to 1")
      ->check(number(0, 1))
      ->type_name("SHARE")
      ->group(kSceneGroup)
      ->default_str("0.1, or the scene's own");
  command.add_option("--speed", settings.speed, "Factor on the scene's speeds")
      ->check(number(0, kTopSpeed))
      ->type_name("FACTOR")
      ->group(kSceneGroup)
      ->capture_default_str();
  command.add_flag("--spinning", settings.spinning, "Moving bodies also turn")->group(kSceneGroup);
  command
      .add_option_function<std::string>(
          "--giant", [this](const std::string& word) { settings.giant = slot_of(word); },
          "Which body is a giant, larger than the world (in scene pile: its plane)")
      ->check(one_of(giant_words()))
      ->type_name("none|first|middle|last")
      ->group(kSceneGroup)
      ->default_str("none");
  command.add_option("--seed", settings.seed, "Seed; the same seed gives the same frames")
      ->check(count())
      ->type_name("N")
      ->group(kSceneGroup)
      ->capture_default_str();
}

void SceneFlags::add_filters_to(CLI::App& command) {
  command
      .add_flag("--static", settings.rest_is_static,
                "Bodies that never move are static, and do not meet each other")
      ->group(kFilterGroup);
  command
      .add_option("--groups", settings.groups, "Bodies belong to N groups in turn, and meet the other groups")
      ->check(count(0, 32))
      ->type_name("N")
      ->group(kFilterGroup)
      ->default_str("0, all meet all");
}

void SceneFlags::exclude_beside(CLI::App& command, CLI::Option& file) {
  for (CLI::Option* option : command.get_options()) {
    const std::string& group = option->get_group();
    if (group == kSceneGroup || group == kFilterGroup) file.excludes(option);
  }
}

std::string SceneFlags::text() const {
  const SceneSettings& s = settings;
  return cellsweep::text(
      "--scene ", s.scene, " --bodies ", s.bodies,
      s.moving ? cellsweep::text(" --moving ", *s.moving) : std::string(), " --speed ", s.speed,
      s.spinning ? " --spinning" : "", s.rest_is_static ? " --static" : "",
      s.groups > 1 ? cellsweep::text(" --groups ", s.groups) : std::string(),
      s.giant == GiantSlot::none ? std::string() : cellsweep::text(" --giant ", word_of(s.giant)), " --seed ",
      s.seed);
}

}  // namespace cellsweep::app
