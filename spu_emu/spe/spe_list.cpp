#include "spe/spe_list.h"

#include <algorithm>

namespace spu_emu {

SpeList& SpeList::instance() {
  static SpeList list;
  return list;
}

void SpeList::add(Spe& spe) {
  const std::lock_guard lock(mutex_);
  spes_.push_back(&spe);
}

void SpeList::remove(Spe& spe) {
  const std::lock_guard lock(mutex_);
  spes_.erase(std::remove(spes_.begin(), spes_.end(), &spe), spes_.end());
}

}  // namespace spu_emu
