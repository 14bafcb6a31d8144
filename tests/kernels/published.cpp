#include "published.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace finback::kernels {

namespace {

constexpr std::uint32_t kFloat2 = 0x40000000;
constexpr std::uint32_t kFloat1 = 0x3f800000;

Published fir_of(std::size_t samples, std::size_t taps) {
  return {"fir_fr16",
          fmt::format("{} samples, {} taps", samples, taps),
          static_cast<Cycles>(64 + samples / 2 * (3 + taps)),
          "formula",
          true,
          [=] { return fir(noise(samples), noise(taps)); }};
}

Published product_of(std::size_t rows, std::size_t inner, std::size_t columns) {
  return {
      "matmmlt_fr16",
      fmt::format("{} x {} by {} x {}", rows, inner, inner, columns),
      static_cast<Cycles>(56 + rows * (10 + columns * (4 + inner))),
      "measured",
      true,
      [=] { return multiply(noise(rows * inner), noise(inner * columns), rows, inner, columns); }};
}

Published transpose_of(std::size_t rows, std::size_t columns, bool reached) {
  return {"transpm_fr16",
          fmt::format("{} x {}", rows, columns),
          static_cast<Cycles>(42 + columns * (rows + 4)),
          "measured",
          reached,
          [=] { return transpose(noise(rows * columns), rows, columns); }};
}

Published of_vector(const std::string& kernel, std::size_t samples, Cycles cycles, bool reached) {
  return {kernel,  fmt::format("{} samples", samples),
          cycles,  "measured",
          reached, [=] { return over_vector(kernel, noise(samples)); }};
}

}  // namespace

bool within(std::int64_t difference, const Published& figure) {
  const Cycles tolerance = std::max<Cycles>(4, figure.cycles / 50);
  return std::abs(difference) <= static_cast<std::int64_t>(tolerance);
}

std::int64_t difference(const Published& figure, KernelCall call) {
  return static_cast<std::int64_t>(call.run()) - static_cast<std::int64_t>(figure.cycles);
}

Halves noise(std::size_t count) {
  Halves values(count);
  std::uint32_t state = 12345;
  for (std::int16_t& value : values) {
    state = state * 1664525 + 1013904223;
    value = static_cast<std::int16_t>(state >> 16);
  }
  return values;
}

// Buffers: 0 input, 1 output, 2 the state, 3 taps, 4 delay line.
KernelCall fir(const Halves& input, const Halves& taps) {
  KernelCall call("fir_fr16");
  call.buffer(input)
      .buffer(Halves(input.size()))
      .number(static_cast<std::int64_t>(input.size()))
      .record({"@3", "@4", "@4", std::to_string(taps.size())})
      .hidden_buffer(taps)
      .hidden_buffer(Halves(taps.size() + 2));
  return call;
}

// Buffers: 0 x, 1 y, 2 the product.
KernelCall multiply(const Halves& x, const Halves& y, std::size_t rows, std::size_t inner,
                    std::size_t columns) {
  KernelCall call("matmmlt_fr16");
  call.buffer(x)
      .number(static_cast<std::int64_t>(rows))
      .number(static_cast<std::int64_t>(inner))
      .buffer(y)
      .number(static_cast<std::int64_t>(columns))
      .buffer(Halves(rows * columns));
  return call;
}

// Buffers: 0 a, 1 the transposed.
KernelCall transpose(const Halves& a, std::size_t rows, std::size_t columns) {
  KernelCall call("transpm_fr16");
  call.buffer(a)
      .number(static_cast<std::int64_t>(rows))
      .number(static_cast<std::int64_t>(columns))
      .buffer(Halves(a.size()));
  return call;
}

KernelCall over_vector(const std::string& kernel, const Halves& x) {
  KernelCall call(kernel);
  call.buffer(x).number(static_cast<std::int64_t>(x.size()));
  return call;
}

const std::vector<Published>& published() {
  static const std::vector<Published> all = {
      fir_of(256, 8),
      fir_of(256, 32),
      fir_of(64, 20),
      product_of(4, 4, 4),
      product_of(10, 10, 10),
      product_of(8, 32, 16),
      transpose_of(32, 32, true),
      transpose_of(20, 40, true),
      transpose_of(8, 8, false),
      of_vector("vecmax_fr16", 24, 56, true),
      of_vector("mean_fr16", 20, 88, true),
      of_vector("var_fr16", 64, 143 + 64, false),
      of_vector("var_fr16", 255, 143 + 255, false),
      {"countones", "one call", 16, "measured", true,
       [] { return KernelCall("countones").number(0x12345678); }},
      {"sqrt_fr16", "one call", 44, "measured", true,
       [] { return KernelCall("sqrt_fr16").number(20000); }},
      {"div16", "one call", 35, "measured", true,
       [] { return KernelCall("div16").number(30000).number(-7); }},
      {"float_gt", "one call", 29, "measured", true,
       [] { return KernelCall("float_gt").number(kFloat2).number(kFloat1); }},
  };
  return all;
}

const std::vector<Terms>& published_terms() {
  static const std::vector<Terms> all = {
      {"fir_fr16", 64, "samples / 2 (3 + taps)"},
      {"matmmlt_fr16", 56, "rows (10 + columns (4 + inner))"},
      {"transpm_fr16", 42, "columns (rows + 4)"},
      {"var_fr16", 143, "samples"},
  };
  return all;
}

}  // namespace finback::kernels
