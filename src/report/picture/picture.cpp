#include "report/picture/picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <system_error>
#include <thread>

#include "base/text.h"
#include "report/picture/camera.h"
#include "report/picture/stage.h"

namespace cellsweep::report {
namespace {

constexpr unsigned kMostPixels = 16384;
constexpr unsigned kMostSamples = 4096;
constexpr unsigned kMostThreads = 1024;
constexpr unsigned kPixelPurpose = 0;

Status check(const char* setting, unsigned value, unsigned least, unsigned most) {
  if (value >= least && value <= most) return {};
  return Status::bad_option(
      setting, text("The ", setting, " of a picture: ", least, " to ", most, ", not ", value, "."), value,
      most);
}

Status check(const PictureSettings& settings) {
  if (Status status = check("width", settings.width, 1, kMostPixels); !status.ok()) return status;
  if (Status status = check("height", settings.height, 1, kMostPixels); !status.ok()) return status;
  if (Status status = check("threads", settings.threads, 0, kMostThreads); !status.ok()) return status;
  return check("samples", settings.samples, 1, kMostSamples);
}

// Bright light is compressed, not cut off; the square root stands for sRGB's curve.
std::uint8_t byte_of(float light) {
  const float compressed = light * (1 + 0.12F * light) / (1 + 0.22F * light);
  return static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(compressed, 0.0F, 1.0F))));
}

class Tracer {
 public:
  Tracer(const Tableau& tableau, const PictureSettings& settings)
      : settings_(settings),
        stage_(tableau),
        camera_(tableau.world, settings.width, settings.height),
        image_{settings.width, settings.height,
               std::vector<std::uint8_t>(std::size_t{3} * settings.width * settings.height)} {}

  Image trace() {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::thread> others;
    start(others, (settings_.threads == 0 ? cores : settings_.threads) - 1);
    trace_rows(settings_.row_done);
    for (std::thread& other : others) other.join();
    return std::move(image_);
  }

 private:
  // Where the system gives no more of them, those that there are do it all.
  void start(std::vector<std::thread>& threads, unsigned count) {
    threads.reserve(count);
    try {
      while (threads.size() < count) threads.emplace_back([this] { trace_rows([](unsigned) {}); });
    } catch (const std::system_error&) {
    }
  }

  void trace_rows(const std::function<void(unsigned)>& row_done) {
    for (unsigned row = next_row_++; row < settings_.height; row = next_row_++) {
      for (unsigned column = 0; column < settings_.width; ++column) trace_pixel(column, row);
      row_done(row);
    }
  }

  void trace_pixel(unsigned column, unsigned row) {
    const std::size_t pixel = std::size_t{row} * settings_.width + column;
    const Samples samples(pixel);
    Light sum = Light::Zero();
    for (unsigned index = 0; index < settings_.samples; ++index) {
      const Point2 place = samples.point(index, kPixelPurpose);
      const Ray ray =
          camera_.ray_through(static_cast<float>(column) + place.x, static_cast<float>(row) + place.y);
      sum += stage_.seen_by(ray, samples, index).cwiseMin(1.0F);
    }
    for (int channel = 0; channel < 3; ++channel) {
      image_.rgb[3 * pixel + static_cast<std::size_t>(channel)] =
          byte_of(sum[channel] / static_cast<float>(settings_.samples));
    }
  }

  PictureSettings settings_;
  Stage stage_;
  Camera camera_;
  Image image_;
  std::atomic<unsigned> next_row_ = 0;
};

}  // namespace

Result<Image> trace_picture(const Tableau& tableau, const PictureSettings& settings) {
  if (Status status = check(settings); !status.ok()) return status;
  return Tracer(tableau, settings).trace();
}

}  // namespace cellsweep::report
