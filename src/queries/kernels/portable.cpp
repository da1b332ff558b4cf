#include "queries/kernels/body.h"
#include "queries/kernels/sets.h"

namespace cellsweep::queries {
namespace {

/// Four boxes at a time in plain C++.
struct PortableQueryLanes : LanesInOrder<4> {
  using Vector [[gnu::vector_size(16)]] = float;
  using Mask [[gnu::vector_size(16)]] = std::int32_t;
  using Doubles [[gnu::vector_size(16)]] = double;

  static void gather(const std::byte* boxes, std::size_t step, std::uint32_t /*there*/, Vector (&faces)[6]) {
    const auto number = [&](unsigned box, unsigned face) {
      return reinterpret_cast<const float*>(boxes + box * step)[face];
    };
    for (unsigned face = 0; face < 6; ++face)
      faces[face] = Vector{number(0, face), number(1, face), number(2, face), number(3, face)};
  }
  /// Of the numbers whose bits are set the lane of the least.
  static unsigned least(const float (&numbers)[16], std::uint32_t bits) {
    auto lane = static_cast<unsigned>(__builtin_ctz(bits));
    for (bits &= bits - 1; bits != 0; bits &= bits - 1) {
      const auto other = static_cast<unsigned>(__builtin_ctz(bits));
      lane = numbers[other] < numbers[lane] ? other : lane;
    }
    return lane;
  }
  static Doubles doubles(Vector floats, unsigned first) { return Doubles{floats[first], floats[first + 1]}; }
  static Doubles roots(Doubles squares) {
    return Doubles{__builtin_sqrt(squares[0]), __builtin_sqrt(squares[1])};
  }
  static Vector not_negative(Vector a) { return larger(a, Vector{}); }
  static Mask less_equal(Vector a, Vector b) { return a <= b; }
  static std::uint32_t bits(Mask mask) {
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < kCount; ++i) bits |= static_cast<std::uint32_t>(mask[i]) & (1U << i);
    return bits;
  }
};

}  // namespace

constinit const TreeKernels kPortableTrees = make_tree_kernels<PortableQueryLanes>();
constinit const QueryKernels kPortableQueries =
    make_query_kernels<PortableQueryLanes, PortableQueryLanes, PortableQueryLanes>(VectorIsa::portable,
                                                                                   kPortableTrees);

}  // namespace cellsweep::queries
