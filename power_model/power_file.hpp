// Power files: other numbers for the power model, in TOML, each by its dotted name (docs/power.md).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <power_model/power_parameters.hpp>

namespace finback::power {

// Sets what the text names; the rest stays. Throws InputError "file:line:column: what" for text
// that is no TOML, unknown keys (naming the nearest), wrong types and values out of range.
void read_power_parameters(std::string_view text, const std::string& file,
                           PowerParameters& parameters);
void load_power_parameters(const std::filesystem::path& path, PowerParameters& parameters);

}  // namespace finback::power
