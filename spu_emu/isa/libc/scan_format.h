/// @file
/// The scanf family for an SPU program: its format and the places for its results lie in the local store.
#ifndef SPU_EMU_ISA_LIBC_SCAN_FORMAT_H
#define SPU_EMU_ISA_LIBC_SCAN_FORMAT_H

#include <cstdio>
#include <string>

#include "isa/libc/store_bytes.h"

namespace spu_emu::isa {

/// Characters one by one, with the last one given back at most once.
class ScanSource {
 public:
  virtual ~ScanSource() = default;
  /// The next character, or EOF.
  virtual int next() = 0;
  virtual void give_back(int c) = 0;
};

class TextSource final : public ScanSource {
 public:
  /// `text` outlives the source.
  explicit TextSource(const std::string& text) : text_(text) {}
  int next() override { return at_ < text_.size() ? static_cast<unsigned char>(text_[at_++]) : EOF; }
  void give_back(int c) override {
    if (c != EOF) --at_;
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

class StreamSource final : public ScanSource {
 public:
  explicit StreamSource(std::FILE* stream) : stream_(stream) {}
  int next() override { return std::fgetc(stream_); }
  void give_back(int c) override { std::ungetc(c, stream_); }

 private:
  std::FILE* stream_;
};

/// Number of results stored, or EOF when the input ended before the first. Throws BadAddress.
int scan_format(StoreBytes& store, ScanSource& source, const std::string& format, ArgumentList& arguments);

}  // namespace spu_emu::isa

#endif
