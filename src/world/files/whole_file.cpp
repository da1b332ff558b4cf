#include "world/files/whole_file.h"

#include <string>

#include "cellsweep/engine/new_file.h"
#include "world/files/file_fault.h"

namespace cellsweep {

Status refusal_of_file(const std::filesystem::path& path, std::string_view reason) {
  return bad_recording(path.string() + ": " + std::string(reason));
}

Status write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  return write_new_file(path.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace cellsweep
