#include "bench/peers/tail_suite.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <span>
#include <string>
#include <vector>

#include "bench/peers/peer_run.h"
#include "bench/peers/peer_table.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kFrames = 1'000;

// Of all threads of the process.
long involuntary_switches() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_nivcsw;
}

void run_row(benchmark::State& state, const PeerInfo& peer, const PeerSetting& setting) {
  PeerRun run(peer, setting);
  std::vector<double> undisturbed;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kFrames; ++i) {
      const long switches = involuntary_switches();
      const double seconds = run.next_frame();
      if (involuntary_switches() == switches) undisturbed.push_back(seconds);
    }
    state.SetIterationTime(report::quantile(undisturbed, 0.5));
  }
  if (undisturbed.empty()) return state.SkipWithError("no frame without an involuntary switch");
  const double p99 = report::quantile(undisturbed, 0.99);
  state.counters["p99"] = 1e6 * p99;
  state.counters["p99/median"] = p99 / report::quantile(undisturbed, 0.5);
  state.counters["frames"] = static_cast<double>(undisturbed.size());
}

}  // namespace

void register_tail_suite() {
  for (const PeerInfo& peer : peer_table()) {
    if (peer.name != "stream") continue;
    for (const std::string_view scene : std::span(kPeerScenes).first(kScenesThatMoveAsTold)) {
      for (const std::size_t bodies : kPeerBodies) {
        if (bodies < 10'000) continue;
        const PeerSetting setting{std::string(scene), bodies, PeerMode::dyn10};
        const std::string name = "p99/stream/" + setting.scene + "/" + std::to_string(bodies) + "/dyn10";
        benchmark::RegisterBenchmark(
            name.c_str(), [&peer, setting](benchmark::State& state) { run_row(state, peer, setting); })
            ->UseManualTime()
            ->Iterations(1)
            ->Unit(benchmark::kMicrosecond);
      }
    }
  }
}

}  // namespace cellsweep::bench
