// The instruction cache against a plain one, with ways locked and lines of importance.
#include <gtest/gtest.h>
#include <list>
#include <map>
#include <random>

#include <memory_model/code_cache.hpp>

namespace finback::memory {
namespace {

// Lines of one set, the one not used for longest in front.
struct PlainLine {
  Address line;
  bool important;
};

class PlainCodeCache {
 public:
  // Whether it was there; it is now.
  bool fetch(Address address, bool important) {
    std::list<PlainLine>& lines = sets_[{address / 4096 % 4, address / 32 % 32}];
    auto line = std::find_if(lines.begin(), lines.end(),
                             [&](const PlainLine& l) { return l.line == address / 32; });
    const bool hit = line != lines.end();
    if (!hit) {
      if (lines.size() == 4) {
        const auto goes = std::find_if(lines.begin(), lines.end(),
                                       [](const PlainLine& l) { return !l.important; });
        lines.erase(goes == lines.end() ? lines.begin() : goes);
      }
      line = lines.insert(lines.end(), {address / 32, important});
    }
    lines.splice(lines.end(), lines, line);
    return hit;
  }
  void forget(Address address) {
    std::erase_if(sets_[{address / 4096 % 4, address / 32 % 32}],
                  [&](const PlainLine& l) { return l.line == address / 32; });
  }

 private:
  std::map<std::pair<Address, Address>, std::list<PlainLine>> sets_;
};

TEST(CodeCache, HoldsWhatAPlainOneHolds) {
  CodeCache cache;
  cache.configure(true);
  PlainCodeCache plain;
  std::mt19937 random(3);
  int hits = 0;
  for (int step = 0; step < 100'000; ++step) {
    // Eight lines in each of a few sets, which differ in bits 10, 11 and 14.
    const auto bits = static_cast<Address>(random());
    const Address address = (bits & 0x4C00) | (bits & 0x1000) | (bits & 0x60) | (bits & 0x1F);
    const bool important = random() % 8 == 0;
    if (random() % 20 == 0) {
      cache.forget(address);
      plain.forget(address);
      continue;
    }
    const bool hit = cache.holds(address);
    hit ? cache.touch(address) : cache.fill(address, important);
    ASSERT_EQ(hit, plain.fetch(address, important)) << "step " << step;
    hits += hit;
  }
  EXPECT_GT(hits, 10'000);
}

TEST(CodeCache, LockedWaysKeepWhatTheyHave) {
  constexpr Address kApart = 0x4000;
  CodeCache cache;
  cache.configure(true);
  cache.fill(0, false);  // way 0
  cache.lock(1);
  for (Address tag = 1; tag <= 4; ++tag) {
    cache.fill(tag * kApart, false);
  }
  EXPECT_TRUE(cache.holds(0));
  EXPECT_FALSE(cache.holds(kApart));
  EXPECT_TRUE(cache.holds(2 * kApart));
  EXPECT_TRUE(cache.holds(4 * kApart));
  cache.lock(0xF);
  cache.fill(5 * kApart, false);
  EXPECT_FALSE(cache.holds(5 * kApart));
}

}  // namespace
}  // namespace finback::memory
