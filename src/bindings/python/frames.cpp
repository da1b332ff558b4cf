#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/arrays.h"
#include "bindings/python/errors.h"
#include "bindings/python/parts.h"
#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/recording.h"
#include "cellsweep/world/scene.h"

namespace cellsweep::python {
namespace {

using namespace py::literals;

/// A source that Python iterates over: its first frame is the one that it stands at.
class Frames {
 public:
  Frames(std::unique_ptr<FrameSource> source, std::optional<std::size_t> count)
      : source_(std::move(source)), count_(count) {
    raise_unless_ok(source_->status());
  }

  const FrameSource& source() const { return *source_; }
  std::optional<std::size_t> count() const { return count_; }

  /// False when there is none.
  bool advance() {
    const bool advanced = source_->advance();
    raise_unless_ok(source_->status());
    return advanced;
  }

  py::array_t<float> next() {
    if (has_begun_ && !advance()) throw py::stop_iteration();
    has_begun_ = true;
    return boxes();
  }

  py::array_t<float> boxes() const {
    const auto boxes = source_->boxes();
    return hand_over_boxes({boxes.begin(), boxes.end()});
  }

 private:
  std::unique_ptr<FrameSource> source_;
  std::optional<std::size_t> count_;
  bool has_begun_ = false;
};

py::array_t<BodyId> copied(std::span<const BodyId> ids) {
  return hand_over_list(std::vector(ids.begin(), ids.end()));
}

std::unique_ptr<Frames> make_scene(const std::string& name, std::size_t bodies, std::uint64_t seed,
                                   std::optional<double> moving, double speed, bool spinning) {
  SceneSettings settings;
  settings.scene = name;
  settings.bodies = bodies;
  settings.seed = seed;
  settings.moving = moving;
  settings.speed = speed;
  settings.spinning = spinning;
  auto made = make_scene_frames(settings);
  raise_unless_ok(made.status());
  return std::make_unique<Frames>(std::move(*made), std::nullopt);
}

std::unique_ptr<Frames> read_frames(const std::string& path) {
  const auto read = read_frame_file(path);
  raise_unless_ok(read.status());
  return std::make_unique<Frames>(read->make_source(), read->frames());
}

/// One frame after the other in one array, (frames, n, 2, 3).
void write_frames(const std::string& path, const py::object& frames, const std::string& name) {
  const auto array = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(frames);
  if (!array || array.ndim() != 4 || array.shape(2) != 2 || array.shape(3) != 3) {
    PyErr_Clear();
    throw py::value_error("Frames have the shape (frames, n, 2, 3).");
  }
  Recording recording;
  recording.name = name;
  recording.bodies = static_cast<std::size_t>(array.shape(1));
  const auto* boxes = reinterpret_cast<const Aabb*>(array.data());
  recording.boxes.assign(boxes, boxes + array.shape(0) * array.shape(1));
  if (!recording.boxes.empty()) recording.world = recording.boxes.front();
  for (const Aabb& box : recording.boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      recording.world.min[axis] = std::min(recording.world.min[axis], box.min[axis]);
      recording.world.max[axis] = std::max(recording.world.max[axis], box.max[axis]);
    }
  }
  raise_unless_ok(write_recording(recording, path));
}

py::list scenes() {
  py::list rows;
  for (const SceneInfo& info : scene_table()) {
    rows.append(py::make_tuple(std::string(info.name), std::string(info.summary)));
  }
  return rows;
}

}  // namespace

void add_frames(py::module_& module) {
  py::class_<Frames>(module, "Frames", R"(Frames of boxes: of a scene without end, or of a file.

Iterating gives the boxes of each frame, (n, 2, 3) float32, from the one that it stands at.
The other members speak of the frame that was given last. One thread at a time.)")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Frames::next)
      .def("advance", &Frames::advance, R"(Goes to the next frame; False when there is none.)")
      .def_property_readonly(
          "name", [](const Frames& of) { return of.source().name(); }, R"(A scene's or a file's.)")
      .def_property_readonly("count", &Frames::count, R"(How many frames there are; None without end.)")
      .def_property_readonly("boxes", &Frames::boxes, R"((n, 2, 3) float32 by id. A copy.)")
      .def_property_readonly(
          "bodies", [](const Frames& of) { return copied(of.source().bodies()); },
          R"(The ids of the bodies that are there, ascending.)")
      .def_property_readonly(
          "moved", [](const Frames& of) { return copied(of.source().moved()); },
          R"(Those whose boxes have changed since the frame before.)")
      .def_property_readonly(
          "inserted", [](const Frames& of) { return copied(of.source().inserted()); },
          R"(Those that were not there in the frame before.)")
      .def_property_readonly(
          "removed", [](const Frames& of) { return copied(of.source().removed()); },
          R"(Those that are not there any more.)");
  module.def("scene", make_scene, "name"_a = "paper", py::kw_only(), "bodies"_a = 1024, "seed"_a = 1,
             "moving"_a = py::none(), "speed"_a = 1.0, "spinning"_a = false,
             R"(Frames of a scene made from a seed; scenes() lists the names. The same bits on every machine.

moving: the share of bodies that move, 0 to 1; None: the scene's own.
Raises OptionError.)");
  module.def("scenes", scenes, R"(The scenes that there are: a list of (name, summary).)");
  module.def(
      "read_frames", read_frames, "path"_a,
      R"(Frames of a recording (.aabbs, .npy) or a trace (.npz). Raises InputError with the place at fault.)");
  module.def(
      "write_frames", write_frames, "path"_a, "frames"_a, py::kw_only(), "name"_a = "",
      R"(Writes (frames, n, 2, 3) boxes, which become float32, to a .aabbs or .npy file, whole or not at all.

Raises InputError, WriteError.)");
}

}  // namespace cellsweep::python
