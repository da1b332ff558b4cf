#include "report/picture/image.h"

#include <png.h>

#include <new>

#include "report/text_file.h"

namespace cellsweep::report {

std::string png_of(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  const auto write = [&](void* bytes, png_alloc_size_t& size) {
    return png_image_write_to_memory(&header, bytes, &size, 0, image.rgb.data(), 0, nullptr) != 0;
  };
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (!write(bytes.data(), size)) throw std::bad_alloc();
  bytes.resize(size);
  return bytes;
}

Status write_png(const Image& image, const std::filesystem::path& path) {
  return write_text_file(path, png_of(image));
}

}  // namespace cellsweep::report
