#include "mfc/mailbox.h"

namespace spu_emu {

void Mailbox::append(std::uint32_t message) {
  messages_[(first_ + count_.load(std::memory_order_relaxed)) % capacity_] = message;
  count_.fetch_add(1);
}

bool Mailbox::try_write(std::uint32_t message) {
  if (space() == 0) return false;
  const std::lock_guard lock(mutex_);
  if (space() == 0) return false;
  append(message);
  return true;
}

void Mailbox::write_over(std::uint32_t message) {
  const std::lock_guard lock(mutex_);
  if (space() == 0) {
    messages_[(first_ + capacity_ - 1) % capacity_] = message;
  } else {
    append(message);
  }
}

std::vector<std::uint32_t> Mailbox::messages() {
  const std::lock_guard lock(mutex_);
  std::vector<std::uint32_t> all;
  for (unsigned i = 0; i < count(); ++i) all.push_back(messages_[(first_ + i) % capacity_]);
  return all;
}

bool Mailbox::try_read(std::uint32_t& message) {
  if (count() == 0) return false;
  const std::lock_guard lock(mutex_);
  if (count() == 0) return false;
  message = messages_[first_];
  first_ = (first_ + 1) % capacity_;
  count_.fetch_sub(1);
  return true;
}

}  // namespace spu_emu
