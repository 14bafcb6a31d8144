// The declared numbers of the two cameras: what their registers would be set to over SCCB, and when
// they run.
#pragma once

#include <common/parameter.hpp>

namespace finback::peripheral {

struct CameraParameters final : ParameterGroup {
  RealParameter frame_rate{
      this,
      {"camera.frame_rate", "Hz", 30, 0.1, 240, 'M', "OV7660 data sheet; hardware.md 3.3",
       "frames a second; the pixel clock is this times the clocks of a frame: 23.99 MHz of VGA"}};
  IntegerParameter halvings{
      this,
      {"camera.halvings", "", 0, 0, 2, 'M', "OV7660 data sheet",
       "0: VGA, 640x480; 1: QVGA; 2: QQVGA. Each halves both sides of the picture, the pixel clock "
       "and the lines of a frame"}};
  IntegerParameter line_pixels{
      this,
      {"camera.line_pixels", "pixels", 784, 644, 4096, 'M', "OV7660 data sheet",
       "a line with its horizontal blanking, in pixels of two clocks each; of every size"}};
  IntegerParameter frame_lines{this,
                               {"camera.frame_lines", "lines", 510, 500, 4096, 'M',
                                "OV7660 data sheet", "a VGA frame with its vertical blanking"}};
  IntegerParameter top_lines{
      this,
      {"camera.top_lines", "lines", 20, 1, 4096, 'M', "OV7660 data sheet",
       "from VSYNC to the first line of a VGA picture: 3 of the pulse, 17 of blanking"}};
  IntegerParameter itu656{
      this,
      {"camera.itu656", "", 0, 0, 1, 'M', "OV7660 data sheet",
       "1: the data carry ITU-R BT.656 codes (progressive, field 0); 0: HREF and VSYNC alone"}};
  RealParameter left_offset{
      this,
      {"camera.left_offset_us", "us", 0, 0, 1e6, 'E', "free-running oscillators",
       "when the first frame of the left camera begins"}};
  RealParameter right_offset{
      this,
      {"camera.right_offset_us", "us", 0, 0, 1e6, 'E', "free-running oscillators",
       "when the first frame of the right camera begins"}};
  RealParameter jitter{this,
                       {"camera.jitter_us", "us", 0, 0, 1e5, 'E', "free-running oscillators",
                        "each frame begins up to so much late, by chance"}};
  RealParameter dropped_share{this,
                              {"camera.dropped_share", "", 0, 0, 0.9, 'E', "none",
                               "the share of frames that a camera does not send, by chance"}};
  RealParameter late_share{this,
                           {"camera.late_share", "", 0, 0, 1, 'E', "none",
                            "the share of frames that begin camera.late_us late, by chance"}};
  RealParameter late{this,
                     {"camera.late_us", "us", 5000, 0, 1e6, 'E', "none",
                      "how late the frames of camera.late_share are"}};
  IntegerParameter seed{this,
                        {"camera.seed", "", 1, 0, 1e9, 'E', "none",
                         "which chances: the same seed gives the same frames at the same times"}};
};

}  // namespace finback::peripheral
