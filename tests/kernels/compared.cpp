#include "compared.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

#include "published.hpp"

namespace finback::kernels {

namespace {

using std::int16_t;
using std::int32_t;
using std::int64_t;
using std::size_t;
using std::uint32_t;
using std::uint8_t;

// `count` values of noise, each brought into its range.
template <typename T>
std::vector<T> noise_of(size_t count, const std::function<int(int)>& ranged) {
  std::vector<T> values;
  for (const int16_t value : noise(count)) {
    values.push_back(static_cast<T>(ranged(value)));
  }
  return values;
}
Halves small_noise(size_t count, int divisor) {
  return noise_of<int16_t>(count, [=](int value) { return value / divisor; });
}
Bytes pixels(size_t count) {
  return noise_of<uint8_t>(count, [](int value) { return value & 0xff; });
}
Halves reversed(Halves values) {
  std::ranges::reverse(values);
  return values;
}

Compared dot_product(size_t count) {
  const Halves a = small_noise(count, 12);
  const Halves b = reversed(small_noise(count, 12));
  return {"dot_product", fmt::format("{} samples", count),
          [=](KernelCall& call) { call.buffer(a).buffer(b).number(static_cast<int64_t>(count)); },
          [=](KernelCall& call) {
            const int64_t sum = std::inner_product(a.begin(), a.end(), b.begin(), int64_t{0});
            EXPECT_EQ(static_cast<int32_t>(call.result()), sum);
          }};
}

Compared fir_of(size_t outputs, size_t taps, int tap_divisor) {
  const Halves samples = noise(outputs + taps - 1);
  const Halves h = reversed(small_noise(taps, tap_divisor));
  return {"fir", fmt::format("{} samples, {} taps", outputs, taps),
          [=](KernelCall& call) {
            call.buffer(samples).buffer(h).buffer(Halves(outputs));
            call.number(static_cast<int64_t>(outputs)).number(static_cast<int64_t>(taps));
          },
          [=](KernelCall& call) {
            Halves expected;
            for (size_t i = 0; i < outputs; ++i) {
              const int64_t sum = std::inner_product(
                  h.begin(), h.end(), samples.begin() + static_cast<std::ptrdiff_t>(i), int64_t{0});
              expected.push_back(
                  static_cast<int16_t>(std::clamp<int64_t>((sum + 0x4000) >> 15, -0x8000, 0x7fff)));
            }
            EXPECT_EQ(call.halves(2), expected);
          }};
}

int reversed_bits(int value, int bits) {
  int result = 0;
  for (int i = 0; i < bits; ++i) {
    result |= (value >> i & 1) << (bits - 1 - i);
  }
  return result;
}

Halves angles() {
  Halves table;
  for (int g = 0; g < 128; ++g) {
    const double angle = -2 * std::numbers::pi * reversed_bits(g, 7) / 256;
    for (const double part : {std::cos(angle), std::sin(angle)}) {
      table.push_back(static_cast<int16_t>(std::clamp(std::lround(part * 32768), -32768L, 32767L)));
    }
  }
  return table;
}

// Real and imaginary parts in turn.
void expect_transformed(const Halves& in, const Halves& out) {
  constexpr double kRoundings = 10;  // eight stages round downwards
  for (int frequency = 0; frequency < 256; ++frequency) {
    double re = 0;
    double im = 0;
    for (int n = 0; n < 256; ++n) {
      const double angle = -2 * std::numbers::pi * (frequency * n % 256) / 256;
      const double x = in[static_cast<size_t>(2 * n)];
      const double y = in[static_cast<size_t>(2 * n + 1)];
      re += x * std::cos(angle) - y * std::sin(angle);
      im += x * std::sin(angle) + y * std::cos(angle);
    }
    const auto at = static_cast<size_t>(2 * frequency);
    EXPECT_NEAR(out[at], re / 256, kRoundings) << "frequency " << frequency;
    EXPECT_NEAR(out[at + 1], im / 256, kRoundings) << "frequency " << frequency;
  }
}

Compared fft256(const std::string& input, const Halves& in) {
  return {"fft256", input,
          [=](KernelCall& call) { call.buffer(in).buffer(Halves(512)).buffer(angles()); },
          [=](KernelCall& call) { expect_transformed(in, call.halves(1)); }};
}

Compared matrix_multiply() {
  const Halves a = small_noise(256, 3);
  const Halves b = reversed(small_noise(256, 4));
  return {"matrix_multiply", "16 x 16 by 16 x 16",
          [=](KernelCall& call) { call.buffer(a).buffer(b).buffer(Halves(256)); },
          [=](KernelCall& call) {
            Halves expected;
            for (size_t at = 0; at < 256; ++at) {
              int32_t sum = 0;
              for (size_t k = 0; k < 16; ++k) {
                sum += a[at / 16 * 16 + k] * b[16 * k + at % 16];
              }
              expected.push_back(static_cast<int16_t>(sum >> 15));
            }
            EXPECT_EQ(call.halves(2), expected);
          }};
}

Compared copy(size_t bytes, size_t to, size_t from) {
  const Bytes source = pixels(bytes + 12);
  return {"copy", fmt::format("{} bytes, {}", bytes, to + from == 0 ? "aligned" : "unaligned"),
          [=](KernelCall& call) {
            call.inside(Bytes(bytes + 12, 0xee), to).inside(source, from);
            call.number(static_cast<int64_t>(bytes));
          },
          [=](KernelCall& call) {
            Bytes expected(bytes + 12, 0xee);
            std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(from), bytes,
                        expected.begin() + static_cast<std::ptrdiff_t>(to));
            EXPECT_EQ(call.bytes(0), expected) << bytes << " bytes, " << to << " <- " << from;
          }};
}

Compared census_row(const std::string& size, int values) {
  constexpr size_t kWidth = 160;
  const Bytes image = noise_of<uint8_t>(3 * (kWidth + 8),
                                        [=](int value) { return (value & 0xffff) * values >> 16; });
  const auto row = [=](size_t y) {
    const auto begin = image.begin() + static_cast<std::ptrdiff_t>(y * (kWidth + 8));
    return Bytes(begin, begin + kWidth + 8);
  };
  return {"census_row", size,
          [=](KernelCall& call) {
            call.buffer(row(0)).buffer(row(1)).buffer(row(2)).buffer(Bytes(kWidth, 0xee));
          },
          [=](KernelCall& call) {
            Bytes expected(kWidth);
            for (size_t x = 1; x + 1 < kWidth; ++x) {
              int bits = 0;
              for (const size_t neighbour : {0, 1, 2, 3, 5, 6, 7, 8}) {
                bits = 2 * bits + (row(neighbour / 3)[x - 1 + neighbour % 3] < row(1)[x] ? 1 : 0);
              }
              expected[x] = static_cast<uint8_t>(bits);
            }
            EXPECT_EQ(call.bytes(3), expected);
          }};
}

Compared shd_update_row() {
  constexpr size_t kColumns = 141;
  constexpr size_t kDisparities = 31;
  constexpr size_t kWindow = 15;
  const Halves left = noise(kColumns);
  const Halves right = reversed(noise(kColumns + kDisparities - 1));
  const Halves updates = small_noise(kDisparities, 256);
  const Halves ring =
      noise_of<int16_t>(kWindow * kDisparities, [](int value) { return value & 15; });
  const Halves scores = small_noise(kColumns * kDisparities, 16);
  return {"shd_update_row", "141 columns, 31 disparities",
          [=](KernelCall& call) {
            call.buffer(left).inside(right, 2 * (kDisparities - 1));
            call.buffer(updates).buffer(ring).buffer(scores);
          },
          [=](KernelCall& call) {
            Halves u = updates;
            Halves m = ring;
            Halves s = scores;
            for (size_t i = 0; i < kColumns; ++i) {
              for (size_t d = 0; d < kDisparities; ++d) {
                const int difference = (left[i] ^ right[kDisparities - 1 + i - d]) & 0xffff;
                int16_t& oldest = m[(i + kWindow - 1) % kWindow * kDisparities + d];
                const int newest = std::popcount(static_cast<unsigned>(difference));
                u[d] = static_cast<int16_t>(u[d] + newest - oldest);
                oldest = static_cast<int16_t>(newest);
                s[i * kDisparities + d] = static_cast<int16_t>(s[i * kDisparities + d] + u[d]);
              }
            }
            EXPECT_EQ(call.halves(2), u);
            EXPECT_EQ(call.halves(3), m);
            EXPECT_EQ(call.halves(4), s);
          }};
}

Compared sad16x16(const std::string& size, const Bytes& a, const Bytes& b) {
  constexpr size_t kWidth = 64;
  return {"sad16x16", size, [=](KernelCall& call) { call.buffer(a).buffer(b).number(kWidth); },
          [=](KernelCall& call) {
            int sum = 0;
            for (size_t at = 0; at < 256; ++at) {
              const size_t pixel = at / 16 * kWidth + at % 16;
              sum += std::abs(a[pixel] - b[pixel]);
            }
            EXPECT_EQ(static_cast<int>(call.result()), sum);
          }};
}

int mixed(int one, int other, int fraction) {
  return (256 * one + (other - one) * fraction + 128) >> 8;
}

Compared rectify_row() {
  constexpr size_t kWidth = 160;
  constexpr size_t kSourceWidth = 256;
  const Bytes source = pixels(kSourceWidth * 12);
  const Halves offsets =
      noise_of<int16_t>(kWidth, [](int value) { return (value & 0xffff) % 2815; });
  const Bytes fractions = noise_of<uint8_t>(2 * kWidth, [](int value) { return value >> 4; });
  return {"rectify_row", "160 pixels",
          [=](KernelCall& call) {
            std::vector<std::string> sources;
            for (const int16_t offset : offsets) {
              sources.push_back(fmt::format("@3 + {}", offset));
            }
            call.record(sources).buffer(fractions).buffer(Bytes(kWidth)).hidden_buffer(source);
          },
          [=](KernelCall& call) {
            Bytes expected;
            for (size_t x = 0; x < kWidth; ++x) {
              const auto at = static_cast<size_t>(offsets[x]);
              const int down = fractions[2 * x];
              const int left = mixed(source[at], source[at + kSourceWidth], down);
              const int right = mixed(source[at + 1], source[at + kSourceWidth + 1], down);
              expected.push_back(static_cast<uint8_t>(mixed(left, right, fractions[2 * x + 1])));
            }
            EXPECT_EQ(call.bytes(2), expected);
          }};
}

Compared variance_row(const std::string& size, const Halves& row) {
  constexpr int kWindow = 9;
  return {"variance_row", size,
          [=](KernelCall& call) { call.buffer(row).buffer(Words(row.size() - kWindow + 1)); },
          [=](KernelCall& call) {
            Words expected;
            for (auto begin = row.begin(); begin + kWindow <= row.end(); ++begin) {
              const int sum = std::accumulate(begin, begin + kWindow, 0);
              const int squares = std::inner_product(begin, begin + kWindow, begin, 0);
              expected.push_back(kWindow * squares - sum * sum);
            }
            EXPECT_EQ(call.words(1), expected);
          }};
}

Words noise_words(size_t count) {
  Words values;
  uint32_t state = 1;
  for (size_t i = 0; i < count; ++i) {
    state = state * 1664525 + 1013904223;
    values.push_back(static_cast<int32_t>(state ^ state >> 15));
  }
  return values;
}

Compared quicksort(const std::string& size, const Words& values) {
  return {
      "quicksort", size,
      [=](KernelCall& call) { call.buffer(values).number(static_cast<int64_t>(values.size())); },
      [=](KernelCall& call) {
        Words expected = values;
        std::ranges::sort(expected);
        EXPECT_EQ(call.words(0), expected) << size;
      }};
}

uint32_t divided(uint32_t remainder) {
  for (int bit = 0; bit < 8; ++bit) {
    remainder = remainder >> 1 ^ ((remainder & 1) != 0 ? 0xedb88320 : 0);
  }
  return remainder;
}

// Of all but the last byte.
Compared crc32(const Bytes& data) {
  Words table;
  for (uint32_t i = 0; i < 256; ++i) {
    table.push_back(static_cast<int32_t>(divided(i)));
  }
  const size_t size = data.size() - 1;
  return {
      "crc32", fmt::format("{} bytes", size),
      [=](KernelCall& call) { call.buffer(data).number(static_cast<int64_t>(size)).buffer(table); },
      [=](KernelCall& call) {
        uint32_t crc = 0xffffffff;
        for (size_t i = 0; i < size; ++i) {
          crc = divided(crc ^ data[i]);
        }
        EXPECT_EQ(call.result(), ~crc) << size << " bytes";
      }};
}

Bytes text(const char* characters) {
  return {characters, characters + std::char_traits<char>::length(characters)};
}

// Every alignment of both sides, with lengths that end everywhere in a word.
std::vector<Compared> copies() {
  std::vector<Compared> all;
  for (size_t to = 0; to < 4; ++to) {
    for (size_t from = 0; from < 4; ++from) {
      for (const size_t bytes : {0u, 1u, 2u, 3u, 4u, 5u, 7u, 8u, 13u, 30u, 31u, 32u, 33u}) {
        all.push_back(copy(bytes, to, from));
      }
    }
  }
  return all;
}

std::vector<Compared> sorts() {
  std::vector<Compared> all;
  for (const size_t count : {0u, 1u, 2u, 3u, 15u, 16u, 17u, 18u, 100u, 255u}) {
    all.push_back(quicksort(fmt::format("{} words", count), noise_words(count + 1)));
  }
  Words rising(200);
  std::iota(rising.begin(), rising.end(), -100);
  all.push_back(quicksort("rising", rising));
  all.push_back(quicksort("falling", Words(rising.rbegin(), rising.rend())));
  all.push_back(quicksort("equal", Words(200, 7)));
  Words few = noise_words(200);
  for (int32_t& value : few) {
    value &= 3;
  }
  all.push_back(quicksort("of four values", few));
  all.push_back(quicksort("extremes", {INT32_MAX, INT32_MIN, 0, INT32_MIN, INT32_MAX}));
  return all;
}

}  // namespace

const std::vector<Compared>& compared() {
  static const std::vector<Compared> all = {
      dot_product(256),
      fir_of(256, 32, 16),
      fft256("256 points", small_noise(512, 2)),
      matrix_multiply(),
      copy(1024, 0, 0),
      census_row("160 pixels", 256),
      shd_update_row(),
      sad16x16("256 pixels", pixels(1024), pixels(2000)),
      rectify_row(),
      variance_row("160 samples", noise_of<int16_t>(160, [](int value) { return value & 1023; })),
      quicksort("256 words", noise_words(257)),
      crc32(pixels(1025)),
  };
  return all;
}

const std::vector<Compared>& other_inputs() {
  static const std::vector<Compared> all = [] {
    Halves tone;
    for (int n = 0; n < 256; ++n) {
      const double angle = 2 * std::numbers::pi * 37 * n / 256;
      tone.push_back(static_cast<int16_t>(std::lround(32000 * std::cos(angle))));
      tone.push_back(static_cast<int16_t>(std::lround(32000 * std::sin(angle))));
    }
    Bytes black(1024);
    Bytes white(1024, 255);
    std::vector<Compared> others = {
        dot_product(2),
        dot_product(4),
        dot_product(130),
        fir_of(2, 6, 16),
        fir_of(64, 20, 8),  // saturates
        fft256("a tone", tone),
        census_row("few values", 3),
        sad16x16("black and white", black, white),
        variance_row("steps", noise_of<int16_t>(160, [](int v) { return v < 0 ? 0 : 1023; })),
        crc32({9}),
        crc32(text("ab")),
        crc32(text("123456789.")),
    };
    for (const auto& more : {copies(), sorts()}) {
      others.insert(others.end(), more.begin(), more.end());
    }
    return others;
  }();
  return all;
}

}  // namespace finback::kernels
