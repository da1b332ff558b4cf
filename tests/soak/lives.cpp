#include "soak/lives.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "cellsweep/world/scene.h"
#include "contract/checked_engine.h"
#include "contract/contract_engines.h"
#include "contract/random_caller.h"
#include "fuzz/calls.h"
#include "queries/random_questions.h"
#include "report/verify.h"

namespace cellsweep::soak {
namespace {

using contract::ContractEngine;
using contract::Random;

constexpr std::size_t kBodies[] = {1, 2, 3, 7, 16, 33, 100, 250};
/// For the scenes, of engines that hold more: `stream` has another way for small worlds.
constexpr std::size_t kSceneBodies[] = {60, 200, 700, 4000};
constexpr int kSteps = 40;
constexpr std::size_t kFrames = 25;
/// For questions: trees of several nodes, and cells in cells.
constexpr std::size_t kAskedBodies[] = {17, 100, 250, 700};
constexpr int kAskedSteps = 8;
constexpr std::size_t kBytes = 400;

/// Of an engine whose SPU programs are interpreted.
constexpr std::size_t kBodiesOfSlow = 33;
constexpr int kStepsOfSlow = 8;
constexpr std::size_t kFramesOfSlow = 4;

template <class Rows>
const auto& one_of(Random& random, const Rows& rows) {
  return rows[random.below(std::size(rows))];
}

Outcome live_by_calls(const ContractEngine& engine, Random& random, std::uint64_t seed) {
  const contract::BoxKind& kind = one_of(random, contract::box_kinds());
  const bool slow = is_interpreted(engine);
  const std::size_t any_number = one_of(random, kBodies);
  const std::size_t bodies = slow ? std::min(any_number, kBodiesOfSlow) : any_number;
  const int steps = slow ? kStepsOfSlow : kSteps;
  Outcome outcome{engine.label + ", " + contract::story_of(kind, bodies, seed)};
  contract::CheckedEngine checked(engine, outcome.story);
  contract::RandomCaller caller(checked, kind, bodies, seed);
  testing::AssertionResult right = caller.fill();
  for (int step = 0; step < steps && right; ++step) {
    right = caller.step();
    ++outcome.updates;
    outcome.pairs += checked.model().pairs.size();
  }
  if (!right) outcome.failure = right.message();
  return outcome;
}

/// Everything is asked after each update, and again while changes wait for the next one; the tree for
/// questions is there, or it is not.
testing::AssertionResult ask(const contract::CheckedEngine& checked, const queries::Reference& world,
                             Random& random) {
  if (random.one_in(2)) checked.engine().queries().prepare();
  return queries::answers_are_right(checked.engine().queries(), world, random.bits());
}

Outcome live_by_questions(const ContractEngine& engine, Random& random, std::uint64_t seed) {
  const contract::BoxKind& kind = one_of(random, contract::box_kinds());
  const bool slow = is_interpreted(engine);
  const std::size_t bodies = slow ? kBodiesOfSlow : one_of(random, kAskedBodies);
  Outcome outcome{engine.label + ", questions, " + contract::story_of(kind, bodies, seed)};
  contract::CheckedEngine checked(engine, outcome.story);
  contract::RandomCaller caller(checked, kind, bodies, seed);
  testing::AssertionResult right = caller.fill();
  for (int step = 0; step < (slow ? kStepsOfSlow : kAskedSteps) && right; ++step) {
    right = caller.step();
    const queries::Reference shown{checked.model().shown, checked.model().filters};
    if (right) right = ask(checked, shown, random);
    if (right) right = caller.calls();
    if (right) right = ask(checked, shown, random);
    ++outcome.updates;
    outcome.pairs += checked.model().pairs.size();
  }
  if (!right) outcome.failure = right.message();
  return outcome;
}

/// `stream` alone: what the fuzzer does, from bytes that nothing guides.
Outcome live_by_bytes(Random& random) {
  std::vector<std::uint8_t> bytes(1 + random.below(kBytes));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
  fuzz::CallsOutcome calls = fuzz::make_calls(bytes);
  return {std::move(calls.story), calls.updates, calls.pairs, std::move(calls.failure)};
}

SceneSettings random_settings(Random& random, std::uint64_t seed) {
  const SceneInfo& scene = one_of(random, scene_table());
  SceneSettings settings;
  settings.scene = scene.name;
  settings.bodies = one_of(random, kSceneBodies);
  settings.seed = seed;
  if (scene.moving && random.one_in(2)) settings.moving = random.unit();
  if (scene.is_world) {
    constexpr double kSpeeds[] = {0, 0.01, 1, 1, 1, 30};
    settings.speed = one_of(random, kSpeeds);
    settings.spinning = random.one_in(2);
  }
  constexpr GiantSlot kGiants[] = {GiantSlot::none, GiantSlot::none, GiantSlot::first, GiantSlot::middle,
                                   GiantSlot::last};
  settings.giant = one_of(random, kGiants);
  settings.rest_is_static = random.one_in(4);
  settings.groups = random.one_in(4) ? static_cast<unsigned>(random.below(5)) : 0;
  return settings;
}

std::string describe(const SceneSettings& settings) {
  return "scene " + settings.scene + ", " + std::to_string(settings.bodies) + " bodies, seed " +
         std::to_string(settings.seed);
}

Outcome live_in_scene(const ContractEngine& engine, Random& random, std::uint64_t seed) {
  SceneSettings settings = random_settings(random, seed);
  std::vector<report::FedEngine> engines;
  engines.push_back({contract::make(engine)});
  const std::uint64_t room = is_interpreted(engine) ? kBodiesOfSlow : engines[0].engine.capacity().bodies / 2;
  settings.bodies = static_cast<std::size_t>(std::min<std::uint64_t>(settings.bodies, room));
  Outcome outcome{engine.label + ", " + describe(settings)};
  auto frames = make_scene_frames(settings);
  if (!frames) {
    outcome.failure = frames.status().message;
    return outcome;
  }
  const auto reports =
      report::verify_engines(engines, **frames, is_interpreted(engine) ? kFramesOfSlow : kFrames);
  if (!reports) {
    outcome.failure = reports.status().message;
    return outcome;
  }
  const report::VerifyReport& judged = reports->front();
  outcome.updates = judged.frames;
  outcome.pairs = judged.pairs;
  if (judged.first) outcome.failure = report::describe(*judged.first);
  if (outcome.failure.empty() && !judged.exact()) outcome.failure = "changes were not told right";
  return outcome;
}

/// The engines of that name, or all.
std::vector<ContractEngine> engines_named(std::string_view name) {
  std::vector<ContractEngine> engines = contract::contract_engines();
  if (!name.empty())
    std::erase_if(engines, [&](const ContractEngine& engine) { return engine.name != name; });
  return engines;
}

}  // namespace

Outcome live(std::uint64_t seed, std::string_view only) {
  Random random(seed);
  if (random.one_in(8) && (only.empty() || only == "stream")) return live_by_bytes(random);
  const std::vector<ContractEngine> engines = engines_named(only);
  const ContractEngine& engine = one_of(random, engines);
  if (random.one_in(4)) return live_by_questions(engine, random, seed);
  return random.one_in(2) ? live_by_calls(engine, random, seed) : live_in_scene(engine, random, seed);
}

bool is_engine(std::string_view name) {
  return !engines_named(name).empty();
}

}  // namespace cellsweep::soak
