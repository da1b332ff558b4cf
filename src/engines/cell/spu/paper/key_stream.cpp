#include "engines/cell/spu/paper/key_stream.h"

#include <free_align.h>
#include <malloc_align.h>

#include "engines/cell/spu/common/dma.h"

namespace cellsweep::cell::paper {
namespace {

constexpr unsigned int kLog2Align = 7;

}  // namespace

KeyStream::KeyStream(unsigned long long ea, bool by_list, unsigned int first_tag)
    : ea_(ea), by_list_(by_list), first_tag_(first_tag), capacity_((by_list ? kListBytes : kChunkBytes) / 4) {
  for (unsigned int i = 0; i < 2; ++i) {
    buffers_[i] = static_cast<std::uint32_t*>(_malloc_align(capacity_ * 4, kLog2Align));
    lists_[i] = by_list ? static_cast<mfc_list_element_t*>(_malloc_align(kDmaAlign, kLog2Align)) : nullptr;
  }
}

KeyStream::~KeyStream() {
  for (unsigned int i = 0; i < 2; ++i) {
    _free_align(buffers_[i]);
    if (by_list_) _free_align(lists_[i]);
  }
}

std::uint32_t KeyStream::finish() {
  const std::uint32_t total = sent_ + filled_;
  if (filled_ != 0) send();
  wait_for_tags(3U << first_tag_);
  return total;
}

// The last buffer goes out in whole quadwords; what is behind the last key means nothing.
void KeyStream::send() {
  const unsigned int bytes = round_up(filled_ * 4, 16);
  if (by_list_) {
    send_by_list(bytes);
  } else {
    put_all(buffers_[turn_], ea_, bytes, first_tag_ + turn_);
  }
  ea_ += bytes;
  sent_ += filled_;
  filled_ = 0;
  turn_ ^= 1U;
  wait_for_tag(first_tag_ + turn_);  // until then the other buffer is on its way
}

// A list's elements share the upper half of their addresses, so across a 4 GB boundary single commands do.
void KeyStream::send_by_list(unsigned int bytes) {
  const unsigned int tag = first_tag_ + turn_;
  if (mfc_ea2h(ea_) != mfc_ea2h(ea_ + bytes - 1)) return put_all(buffers_[turn_], ea_, bytes, tag);
  mfc_list_element_t* list = lists_[turn_];
  unsigned int elements = 0;
  for (unsigned int done = 0; done < bytes; done += kMaxTransfer) {
    mfc_list_element_t& element = list[elements++];
    element.notify = 0;
    element.reserved = 0;
    element.size = bytes - done < kMaxTransfer ? bytes - done : kMaxTransfer;
    element.eal = mfc_ea2l(ea_ + done);
  }
  mfc_putl(buffers_[turn_], ea_, list, elements * static_cast<unsigned int>(sizeof(mfc_list_element_t)), tag,
           0, 0);
}

}  // namespace cellsweep::cell::paper
