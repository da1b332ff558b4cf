/// @file
/// The SPEs of the process, for who looks at all of them.
#ifndef SPU_EMU_SPE_SPE_LIST_H
#define SPU_EMU_SPE_SPE_LIST_H

#include <mutex>
#include <vector>

namespace spu_emu {

class Spe;

/// Any thread.
class SpeList {
 public:
  static SpeList& instance();

  /// From the SPE's constructor and its destructor.
  void add(Spe& spe);
  void remove(Spe& spe);

  /// Calls `visit(Spe&)` for each, the oldest first; none comes or goes meanwhile.
  template <class Visit>
  void for_each(Visit&& visit) {
    const std::lock_guard lock(mutex_);
    for (Spe* spe : spes_) visit(*spe);
  }

 private:
  std::mutex mutex_;
  std::vector<Spe*> spes_;
};

}  // namespace spu_emu

#endif
