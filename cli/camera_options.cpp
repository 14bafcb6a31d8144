#include <cli/camera_options.hpp>

namespace finback::cli {

void add_camera_options(CLI::App& command, runner::RunRequest& request, const std::string& group) {
  command
      .add_option("--camera-rate", request.camera_rate,
                  "Frames a second of the cameras (as --set camera.frame_rate)")
      ->type_name("HZ")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command
      .add_option("--distort", request.distortion,
                  "Radial distortion of both lenses, e.g. -0.1,0.01")
      ->type_name("K1,K2")
      ->delimiter(',')
      ->expected(2)
      ->group(group);
  command
      .add_option("--misalign", request.misalignment,
                  "How the right camera is turned and shifted, e.g. 0.5,3,-2")
      ->type_name("DEGREES,X,Y")
      ->delimiter(',')
      ->expected(3)
      ->group(group);
  command
      .add_option("--drop-frame", request.dropped,
                  "A frame that the cameras, or one, do not send, e.g. 12 or left:12; repeatable")
      ->type_name("[SIDE:]FRAME")
      ->allow_extra_args(false)
      ->group(group);
  command
      .add_option("--late-frame", request.late,
                  "A frame that begins late, e.g. 12:5 or left:12:5; repeatable")
      ->type_name("[SIDE:]FRAME:MS")
      ->allow_extra_args(false)
      ->group(group);
}

void add_port_options(CLI::App& command, runner::PortRequest& ports, const std::string& group) {
  command.add_option("--uart", ports.uart, "Where the UART's characters go; -: print them")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--uart-input", ports.uart_input, "What the UART receives")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--flags", ports.flags, "Write the changes of flags that are outputs here")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--flags-input", ports.flags_input,
                  "Changes of flags that are inputs: lines of TIME_US PIN LEVEL")
      ->type_name("FILE")
      ->group(group);
}

}  // namespace finback::cli
