// Power files: what they set, and what is said of wrong ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <common/error.hpp>
#include <power_model/power_file.hpp>

namespace finback::power {
namespace {

using ::testing::HasSubstr;

std::string refused(const char* text) {
  PowerParameters parameters;
  try {
    read_power_parameters(text, "my.toml", parameters);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PowerFile, SetsWhatItNamesAndNothingElse) {
  PowerParameters parameters;
  read_power_parameters("power.core.junction_celsius = 25\n[power.sdram]\nchips = 1\n", "my.toml",
                        parameters);
  EXPECT_EQ(parameters.junction_celsius, 25);
  EXPECT_EQ(parameters.sdram_chips, 1);
  EXPECT_EQ(parameters.regulator_efficiency, 0.80);
}

TEST(PowerFile, NamesTheNearestKey) {
  EXPECT_EQ(refused("[power.sdram]\nchip = 1\n"),
            "my.toml:2:1: unknown key power.sdram.chip, did you mean power.sdram.chips");
}

TEST(PowerFile, RefusesWrongTypesAndValues) {
  EXPECT_EQ(refused("[power.sdram]\nchips = \"two\"\n"),
            "my.toml:2:9: power.sdram.chips wants a number");
  EXPECT_THAT(refused("[power.core]\nregulator_efficiency = 1.5\n"),
              HasSubstr("my.toml:2:24: power.core.regulator_efficiency = 1.5 is out of range"));
}

TEST(PowerFile, RefusesWhatIsNoToml) {
  EXPECT_THAT(refused("[power\nchips = 1\n"), HasSubstr("my.toml:1:"));
}

TEST(PowerFile, EachParameterIsWithinItsRange) {
  PowerParameters parameters;
  for (ParameterBase* parameter : parameters.parameters()) {
    EXPECT_NO_THROW(parameter->set(parameter->declaration().default_value))
        << parameter->declaration().name;
    EXPECT_FALSE(parameter->declaration().source.empty()) << parameter->declaration().name;
  }
}

}  // namespace
}  // namespace finback::power
