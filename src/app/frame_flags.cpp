#include "app/frame_flags.h"

namespace cellsweep::app {

void FrameFlags::add_to(CLI::App& command, std::size_t frames_default, const std::string& frames_text) {
  settings.updates = frames_default;
  command.add_option("--frames", settings.updates, "Updates after frame 0" + frames_text);
  command
      .add_option("--report-frames", settings.report_frames,
                  "Frames whose pair count and hash are reported [first and last]")
      ->delimiter(',')
      ->type_name("FRAME[,FRAME...]");
  command.add_flag("--json", json, "One JSON object on standard output");
}

}  // namespace cellsweep::app
