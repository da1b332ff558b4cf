/// @file
/// Which bracket closes which.
#ifndef SPU_EMU_COMPILE_NESTING_H
#define SPU_EMU_COMPILE_NESTING_H

#include <cstddef>
#include <vector>

#include "compile/tokens.h"

namespace spu_emu::compile {

class Nesting {
 public:
  explicit Nesting(const std::vector<Token>& tokens);

  /// The other bracket of a pair; the token's own number for one that is alone.
  std::size_t partner(std::size_t at) const { return partner_[at]; }
  /// How many braces are open before the token; those of `extern "C" {` do not count.
  unsigned depth(std::size_t at) const { return depth_[at]; }

 private:
  std::vector<std::size_t> partner_;
  std::vector<unsigned> depth_;
};

}  // namespace spu_emu::compile

#endif
