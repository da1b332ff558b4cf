/// @file
/// A rank that gets no memory, at one place of a call after the other.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <optional>
#include <string>

#include "cellsweep/status.h"
#include "contract/effort.h"
#include "contract/faults/starved_call.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {

/// Of a job all of whose ranks make the same collective calls. What a call that failed keeps of memory for
/// the next one may hide a place from it: so the first fault of each call is not always at its first place.
class StarvedRank {
 public:
  StarvedRank(int rank, contract::Lasts lasts, std::uint64_t first_place)
      : rank_(rank), lasts_(lasts), first_place_(first_place) {}

  int rank() const { return rank_; }
  bool is_here() const { return own_rank() == rank_; }
  /// How many calls this rank had refused or saw fail.
  std::uint64_t failures() const { return failures_; }

  /// Makes a call of this rank alone, which returns a Status and is not to be refused, until it gets all.
  template <class Call>
  void call(const Call& call) {
    for (std::uint64_t n = first_place_; !gets_all(call, n); ++n) ++failures_;
  }

  /// Makes a collective call, which returns a Status, until it is not refused. Each refusal is by all ranks,
  /// names the rank, and leaves all as it was on each: `is_kept()`.
  template <class Call, class IsKept>
  void call_all(const char* name, const Call& call, const IsKept& is_kept,
                const contract::Places& places = {}) {
    for (std::uint64_t n = first_place_;; n = places.after(n)) {
      const Status status = with_fault(n, call);
      ASSERT_TRUE(on_all_ranks(status.ok()) || on_all_ranks(!status.ok()))
          << name << " at " << n << ": " << status.message;
      if (status.ok()) return;
      ++failures_;
      const bool has_words = names_rank(status) || (is_here() && status.message == "No memory left.");
      const bool kept = is_kept();
      ASSERT_TRUE(on_all_ranks(has_words && kept))
          << name << " at " << n << ": " << status.message << (kept ? "" : ", and this rank has changed");
      ASSERT_LT(n, 10'000U) << name;
    }
  }

 private:
  bool names_rank(const Status& status) const {
    return status.message.starts_with("Rank " + std::to_string(rank_) + ": ");
  }

  void begin(std::uint64_t n) const {
    if (!is_here()) return;
    contract::let_fail(contract::Scarce::memory, n, lasts_);
    contract::count_calls(true);
  }
  void end() const {
    contract::count_calls(false);
    contract::let_fail(contract::Scarce::memory, 0);
  }

  template <class Call>
  Status with_fault(std::uint64_t n, const Call& call) const {
    std::optional<Status> status;
    bool threw = false;
    begin(n);
    try {
      status.emplace(call());
    } catch (const std::bad_alloc&) {
      threw = true;
    }
    end();
    EXPECT_FALSE(threw) << "at " << n << ": a rank left by an exception what the others were refused";
    if (threw) return Status::bad_input("exception");
    return std::move(*status);
  }

  template <class Call>
  bool gets_all(const Call& call, std::uint64_t n) const {
    begin(n);
    try {
      const Status status = call();
      end();
      EXPECT_TRUE(status.ok()) << status.message;
      return true;
    } catch (const std::bad_alloc&) {
      end();
      return false;
    }
  }

  int rank_;
  contract::Lasts lasts_;
  std::uint64_t first_place_;
  std::uint64_t failures_ = 0;
};

/// The first and the last rank, without memory for one call and for all, from several places on. Returns how
/// many calls failed.
template <class Test>
std::uint64_t for_each_starved_rank(const Test& test) {
  std::uint64_t failures = 0;
  const std::uint64_t last_place = contract::repeated(60U, 6U);
  for (const int rank : {0, all_ranks() - 1}) {
    for (const contract::Lasts lasts : {contract::Lasts::once, contract::Lasts::for_ever}) {
      for (std::uint64_t first = 1; first <= last_place; first += contract::repeated(1U, 5U)) {
        SCOPED_TRACE(testing::Message() << "rank " << rank << " from place " << first << " on"
                                        << (lasts == contract::Lasts::once ? ", once each" : ", for good"));
        StarvedRank starved(rank, lasts, first);
        test(starved);
        failures += starved.failures();
        if (!on_all_ranks(!testing::Test::HasFailure())) return failures;
      }
    }
  }
  return failures;
}

}  // namespace cellsweep::ranks
