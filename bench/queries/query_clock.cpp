#include "bench/queries/query_clock.h"

#include <time.h>

#include <algorithm>
#include <limits>

#include "bench/queries/query_check.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

// All questions are asked so many times over, or only as long as this, whichever is less.
constexpr int kTimesOver = 3;
constexpr double kTooLong = 1;  // seconds

double now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void ask_once(std::span<const Asking> askings, bool in_batches, AnswerRoom& room) {
  for (const Asking& asking : askings) {
    if (in_batches) {
      asking.peer->answer_batch(*asking.questions);
      continue;
    }
    for (std::size_t i = 0; i < asking.questions->size(); ++i) ask(*asking.peer, *asking.questions, i, room);
  }
}

}  // namespace

double mean_seconds(std::span<const Asking> askings, const QueryPeerInfo& info) {
  constexpr double kLongEnough = 0.1;
  const clockid_t clock = info.many_threads ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID;
  std::size_t questions = 0;
  for (const Asking& asking : askings) questions += asking.questions->size();
  AnswerRoom room;
  double fastest = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int i = 0; sum < kLongEnough || (i < kTimesOver && sum < kTooLong); ++i) {
    const double start = now(clock);
    ask_once(askings, info.in_batches, room);
    const double seconds = now(clock) - start;
    fastest = std::min(fastest, seconds);
    sum += seconds;
  }
  return fastest / static_cast<double>(questions);
}

double p99_seconds(std::span<const Asking> askings) {
  AnswerRoom room;
  std::vector<double> fastest;
  const double begin = now(CLOCK_MONOTONIC);
  for (int round = 0; round == 0 || (round < kTimesOver && now(CLOCK_MONOTONIC) - begin < kTooLong);
       ++round) {
    std::size_t place = 0;
    for (const Asking& asking : askings) {
      for (std::size_t i = 0; i < asking.questions->size(); ++i, ++place) {
        const double start = now(CLOCK_MONOTONIC);
        ask(*asking.peer, *asking.questions, i, room);
        const double seconds = now(CLOCK_MONOTONIC) - start;
        if (round == 0) fastest.push_back(seconds);
        fastest[place] = std::min(fastest[place], seconds);
      }
    }
  }
  return report::quantile(fastest, 0.99);
}

double seconds_of(const std::function<void()>& call) {
  const double start = now(CLOCK_MONOTONIC);
  call();
  return now(CLOCK_MONOTONIC) - start;
}

}  // namespace cellsweep::bench
