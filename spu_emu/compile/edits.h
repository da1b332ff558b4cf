/// @file
/// Changes to a text, gathered first and made at once.
#ifndef SPU_EMU_COMPILE_EDITS_H
#define SPU_EMU_COMPILE_EDITS_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace spu_emu::compile {

class Edits {
 public:
  /// Nothing happens inside of what an earlier call has replaced.
  void replace(std::size_t begin, std::size_t end, std::string text);
  void insert(std::size_t at, std::string text) { replace(at, at, std::move(text)); }

  /// Newlines in what is replaced stay, so that lines keep their numbers. Insertions at one place stand in
  /// the order in which they came.
  std::string apply(std::string_view source) const;

 private:
  struct Edit {
    std::size_t begin;
    std::size_t end;
    std::string text;
  };
  std::vector<Edit> edits_;
};

}  // namespace spu_emu::compile

#endif
