#include "report/text_file.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include "base/text.h"
#include "cellsweep/engine/new_file.h"

namespace cellsweep::report {
namespace {

Status file_status(const std::filesystem::path& path, std::string_view what) {
  return Status::bad_input(text(path.string(), ": ", what, "."));
}

}  // namespace

Status write_text_file(const std::filesystem::path& path, std::string_view bytes) {
  return write_new_file(path.string(), bytes);
}

Result<std::string> read_text_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return file_status(path, "the file cannot be read");
  return std::string(std::istreambuf_iterator<char>(file), {});
}

Status make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return file_status(path, "the folder cannot be made: " + error.message());
  return {};
}

}  // namespace cellsweep::report
