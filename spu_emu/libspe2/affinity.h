/// @file
/// Which contexts of a gang asked to lie beside each other. Nothing is placed here; what a Cell's kernel
/// would refuse is refused.
#ifndef SPU_EMU_LIBSPE2_AFFINITY_H
#define SPU_EMU_LIBSPE2_AFFINITY_H

#include <libspe2-types.h>

#include <mutex>
#include <vector>

namespace spu_emu {

/// Of one gang. Any thread.
class Affinity {
 public:
  /// Whether a context with these flags may be made beside `neighbor`, which may be null; else an errno
  /// value: EEXIST when another is at memory, the neighbour has one on both sides or the SPEs of a node are
  /// not enough, EINVAL when the neighbour is of another gang, EBUSY when neighbours have run.
  int check(unsigned int flags, spe_context_ptr_t neighbor) const;
  /// Puts a new context in its place.
  void add(spe_context_ptr_t context, spe_context_ptr_t neighbor);
  void remove(spe_context_ptr_t context);
  /// From the first run of a context with neighbours on, places are settled.
  void note_run(spe_context_ptr_t context);

 private:
  using Chain = std::vector<spe_context_ptr_t>;
  const Chain* chain_of(spe_context_ptr_t context) const;

  mutable std::mutex mutex_;
  std::vector<Chain> chains_;
  spe_context_ptr_t at_memory_ = nullptr;
  bool is_settled_ = false;
};

}  // namespace spu_emu

#endif
