#include "check.h"
#include "operations.h"

namespace {

using namespace reference;

template <int Width, u64 (*Shift)(u64, u64)>
u64 by(u64 value, u64 count) {
  return Shift(value, count % (16 * Width));
}

template <int Width, u64 (*Shift)(u64, u64)>
u64 by_negated(u64 value, u64 count) {
  return Shift(value, (0 - count) % (16 * Width));
}

TEST(SpecificShift, ShiftsAndRotatesLanes) {
  check<qword, qword>(
      "si_shlh", [](qword a, qword b) { return si_shlh(a, b); }, lanewise<2>(by<2, shifted_left<2>>));
  check<qword, int>(
      "si_shlhi", [](qword a, int n) { return si_shlhi(a, n); },
      with_splat<2>(lanewise<2>(by<2, shifted_left<2>>)));
  check<qword, qword>(
      "si_roth", [](qword a, qword b) { return si_roth(a, b); }, lanewise<2>(rotated<2>));
  check<qword, int>(
      "si_rothi", [](qword a, int n) { return si_rothi(a, n); }, with_splat<2>(lanewise<2>(rotated<2>)));
  check<qword, qword>(
      "si_rothm", [](qword a, qword b) { return si_rothm(a, b); },
      lanewise<2>(by_negated<2, shifted_right<2>>));
  check<qword, int>(
      "si_rothmi", [](qword a, int n) { return si_rothmi(a, n); },
      with_splat<2>(lanewise<2>(by_negated<2, shifted_right<2>>)));
  check<qword, qword>(
      "si_rotmah", [](qword a, qword b) { return si_rotmah(a, b); },
      lanewise<2>(by_negated<2, shifted_right_signed<2>>));
  check<qword, int>(
      "si_rotmahi", [](qword a, int n) { return si_rotmahi(a, n); },
      with_splat<2>(lanewise<2>(by_negated<2, shifted_right_signed<2>>)));
  check<qword, qword>(
      "si_shl", [](qword a, qword b) { return si_shl(a, b); }, lanewise<4>(by<4, shifted_left<4>>));
  check<qword, int>(
      "si_shli", [](qword a, int n) { return si_shli(a, n); },
      with_splat<4>(lanewise<4>(by<4, shifted_left<4>>)));
  check<qword, qword>(
      "si_rot", [](qword a, qword b) { return si_rot(a, b); }, lanewise<4>(rotated<4>));
  check<qword, int>(
      "si_roti", [](qword a, int n) { return si_roti(a, n); }, with_splat<4>(lanewise<4>(rotated<4>)));
  check<qword, qword>(
      "si_rotm", [](qword a, qword b) { return si_rotm(a, b); },
      lanewise<4>(by_negated<4, shifted_right<4>>));
  check<qword, int>(
      "si_rotmi", [](qword a, int n) { return si_rotmi(a, n); },
      with_splat<4>(lanewise<4>(by_negated<4, shifted_right<4>>)));
  check<qword, qword>(
      "si_rotma", [](qword a, qword b) { return si_rotma(a, b); },
      lanewise<4>(by_negated<4, shifted_right_signed<4>>));
  check<qword, int>(
      "si_rotmai", [](qword a, int n) { return si_rotmai(a, n); },
      with_splat<4>(lanewise<4>(by_negated<4, shifted_right_signed<4>>)));
}

// Counts of quadword shifts sit in the preferred slot.
template <typename F>
auto by_preferred(F f) {
  return [f](const Register& a, const Register& b) { return f(a, static_cast<int>(signed_lane<4>(b, 0))); };
}

TEST(SpecificShift, ShiftsAndRotatesQuadwords) {
  const auto rotqbi = [](const Register& a, int n) { return moved_around(a, n & 7); };
  check<qword, qword>(
      "si_rotqbi", [](qword a, qword b) { return si_rotqbi(a, b); }, by_preferred(rotqbi));
  check<qword, int>(
      "si_rotqbii", [](qword a, int n) { return si_rotqbii(a, n); }, rotqbi);
  const auto rotqby = [](const Register& a, int n) { return moved_around(a, (n & 15) * 8); };
  check<qword, qword>(
      "si_rotqby", [](qword a, qword b) { return si_rotqby(a, b); }, by_preferred(rotqby));
  check<qword, int>(
      "si_rotqbyi", [](qword a, int n) { return si_rotqbyi(a, n); }, rotqby);
  const auto rotqmbi = [](const Register& a, int n) {
    return moved_left(a, -static_cast<int>((0U - static_cast<unsigned>(n)) & 7));
  };
  check<qword, qword>(
      "si_rotqmbi", [](qword a, qword b) { return si_rotqmbi(a, b); }, by_preferred(rotqmbi));
  check<qword, int>(
      "si_rotqmbii", [](qword a, int n) { return si_rotqmbii(a, n); }, rotqmbi);
  const auto rotqmby = [](const Register& a, int n) {
    return moved_left(a, -8 * static_cast<int>((0U - static_cast<unsigned>(n)) & 31));
  };
  check<qword, qword>(
      "si_rotqmby", [](qword a, qword b) { return si_rotqmby(a, b); }, by_preferred(rotqmby));
  check<qword, int>(
      "si_rotqmbyi", [](qword a, int n) { return si_rotqmbyi(a, n); }, rotqmby);
  const auto shlqbi = [](const Register& a, int n) { return moved_left(a, n & 7); };
  check<qword, qword>(
      "si_shlqbi", [](qword a, qword b) { return si_shlqbi(a, b); }, by_preferred(shlqbi));
  check<qword, int>(
      "si_shlqbii", [](qword a, int n) { return si_shlqbii(a, n); }, shlqbi);
  const auto shlqby = [](const Register& a, int n) { return moved_left(a, (n & 31) * 8); };
  check<qword, qword>(
      "si_shlqby", [](qword a, qword b) { return si_shlqby(a, b); }, by_preferred(shlqby));
  check<qword, int>(
      "si_shlqbyi", [](qword a, int n) { return si_shlqbyi(a, n); }, shlqby);
  check<qword, qword>(
      "si_shlqbybi", [](qword a, qword b) { return si_shlqbybi(a, b); },
      by_preferred([](const Register& a, int n) { return moved_left(a, (n >> 3 & 31) * 8); }));
  check<qword, qword>(
      "si_rotqbybi", [](qword a, qword b) { return si_rotqbybi(a, b); },
      by_preferred([](const Register& a, int n) { return moved_around(a, (n >> 3 & 15) * 8); }));
  check<qword, qword>(
      "si_rotqmbybi", [](qword a, qword b) { return si_rotqmbybi(a, b); },
      by_preferred([](const Register& a, int n) { return moved_left(a, -8 * (-(n >> 3) & 31)); }));
}

}  // namespace
