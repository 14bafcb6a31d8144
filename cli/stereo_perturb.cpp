// `finback stereo perturb`: a picture under other light, or with noise.
#include <fmt/format.h>
#include <memory>

#include <cli/stereo_command.hpp>
#include <scenes/luma.hpp>
#include <stereo_reference/radiometry.hpp>

namespace finback::cli {

namespace {

using namespace stereo_reference;

struct PerturbOptions {
  std::string image;
  double scale = 1;
  double gamma = 1;
  double vignette = 1;
  double noise = 0;
  std::uint32_t seed = 1;
  std::string out;
};

int perturb(const PerturbOptions& options, bool gamma, bool noise) {
  scenes::ByteImage image = scenes::load_luma(options.image);
  image = scale_greys(image, options.scale);
  if (gamma) {  // stretches the greys also where gamma is 1
    image = change_gamma(image, options.gamma);
  }
  image = vignette(image, options.vignette);
  if (noise) {
    image = add_noise(image, noise_variance(image, options.noise), options.seed);
  }
  scenes::write_png(image, options.out);
  return kFine;
}

}  // namespace

void add_stereo_perturb(CLI::App& stereo, Action& action) {
  auto options = std::make_shared<PerturbOptions>();
  CLI::App* command = stereo.add_subcommand("perturb", "Change a picture's light, or add noise");
  command->add_option("image", options->image, "The picture")->type_name("IMAGE")->required();
  command->add_option("--scale", options->scale, "Every grey times this")->type_name("FACTOR");
  const CLI::Option* gamma =
      command->add_option("--gamma", options->gamma, "Greys, stretched to 0..1, to the power 1/G")
          ->type_name("G");
  command
      ->add_option("--vignette", options->vignette,
                   "Darker with the distance from the centre, to this part in the corners")
      ->type_name("PART");
  const CLI::Option* noise =
      command
          ->add_option("--noise", options->noise, "Gaussian noise at this ratio of signal to noise")
          ->type_name("DECIBEL");
  command->add_option("--seed", options->seed, "Of the noise")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--out", options->out, "The picture to write")
      ->type_name("IMAGE.png")
      ->required();
  command->footer(
      "Several changes apply in the order above.\n"
      "Example: finback stereo perturb r.png --gamma 2.5 --noise 20 --out dark.png");
  command->callback([&action, options, gamma, noise] {
    action = [options, with_gamma = gamma->count() > 0, with_noise = noise->count() > 0] {
      return perturb(*options, with_gamma, with_noise);
    };
  });
}

}  // namespace finback::cli
