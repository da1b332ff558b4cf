// Files that lie: every header field of an ELF file with numbers that it should not have, and where to put
// such a file so that a read past its end is noticed.
#ifndef SPU_EMU_TESTS_HOSTILE_LIES_H
#define SPU_EMU_TESTS_HOSTILE_LIES_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace spu_emu {

using FileBytes = std::vector<std::byte>;

/// A number in a file, its bytes in the file's order.
struct Field {
  std::size_t at = 0;
  std::size_t bytes = 0;
};

/// Of every header that is there: the file's, the segments', the sections'; and the first words of note
/// segments.
std::vector<Field> fields_of_spu_elf(const FileBytes& file);
/// Offsets, sizes, addresses and counts of a module's header, and of its segment headers, too.
std::vector<Field> fields_of_module_header();
std::vector<Field> fields_of_module(const FileBytes& file);

using UseFile = std::function<void(const FileBytes& file, const std::string& what)>;

/// Each field with each number that it should not have: around 0, the file's size, the local store's, and the
/// powers of two at which arithmetic wraps.
void for_each_lie(const FileBytes& file, const std::vector<Field>& fields, bool big_endian,
                  const UseFile& use);
/// Random numbers in some random fields at once.
void for_some_lies(const FileBytes& file, const std::vector<Field>& fields, int count, const UseFile& use);
/// The file cut at lengths `step` apart.
void for_each_cut(const FileBytes& file, std::size_t step, const UseFile& use);

/// Memory in which files end where a page begins that nobody may touch.
class GuardedMemory {
 public:
  explicit GuardedMemory(std::size_t most_bytes);
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  /// Until the next call.
  std::span<std::byte> put(const FileBytes& file);

 private:
  std::byte* first_ = nullptr;
  std::size_t size_ = 0;
};

/// SPU programs made by hand, each with something of its own that a loader reads: symbols, a name note,
/// overlays. All stop at once, and know no address.
std::vector<FileBytes> small_spu_programs();

}  // namespace spu_emu

#endif
