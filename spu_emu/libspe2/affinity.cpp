#include "libspe2/affinity.h"

#include <algorithm>
#include <cerrno>

#include "libspe2/context.h"

namespace spu_emu {

const Affinity::Chain* Affinity::chain_of(spe_context_ptr_t context) const {
  for (const Chain& chain : chains_) {
    if (std::find(chain.begin(), chain.end(), context) != chain.end()) return &chain;
  }
  return nullptr;
}

int Affinity::check(unsigned int flags, spe_context_ptr_t neighbor) const {
  const std::lock_guard lock(mutex_);
  const bool wants_memory = (flags & SPE_AFFINITY_MEMORY) != 0;
  if (wants_memory && at_memory_ != nullptr) return EEXIST;
  if (is_settled_ && (wants_memory || neighbor != nullptr)) return EBUSY;
  if (neighbor == nullptr) return 0;
  const Chain* chain = chain_of(neighbor);
  if (chain != nullptr && neighbor != chain->front() && neighbor != chain->back()) return EEXIST;
  if (neighbor->gang == nullptr || &neighbor->gang->affinity != this) return EINVAL;
  std::size_t placed = chain == nullptr ? 2 : 1;
  for (const Chain& each : chains_) placed += each.size();
  return placed > std::size_t{kSpesPerNode} ? EEXIST : 0;
}

void Affinity::add(spe_context_ptr_t context, spe_context_ptr_t neighbor) {
  const std::lock_guard lock(mutex_);
  if ((context->flags & SPE_AFFINITY_MEMORY) != 0) at_memory_ = context;
  if (neighbor == nullptr) return;
  if (chain_of(neighbor) == nullptr) chains_.push_back({neighbor});
  for (Chain& chain : chains_) {
    if (chain.back() == neighbor) {
      chain.push_back(context);
      return;
    }
    if (chain.front() == neighbor) {
      chain.insert(chain.begin(), context);
      return;
    }
  }
}

void Affinity::remove(spe_context_ptr_t context) {
  const std::lock_guard lock(mutex_);
  if (at_memory_ == context) at_memory_ = nullptr;
  for (Chain& chain : chains_) std::erase(chain, context);
  std::erase_if(chains_, [](const Chain& chain) { return chain.empty(); });
}

void Affinity::note_run(spe_context_ptr_t context) {
  const std::lock_guard lock(mutex_);
  if (chain_of(context) != nullptr) is_settled_ = true;
}

}  // namespace spu_emu
