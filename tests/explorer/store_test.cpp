// What is kept, and what files are refused.
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sqlite3.h>
#include <unistd.h>

#include <common/error.hpp>
#include <common/file.hpp>
#include <explorer/store.hpp>

namespace finback::explorer {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StoreTest : public ::testing::Test {
 public:
  ~StoreTest() override { fs::remove_all(folder_); }

 protected:
  StoreTest() {
    std::string pattern = (fs::temp_directory_path() / "finback-test-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    path_ = folder_ / "kept" / "space.sqlite";
  }

  static Identity identity(const std::string& key) {
    Identity identity;
    identity.key = key;
    return identity;
  }
  static Result result(double rate) {
    return {"", {{"frames_per_second", {rate, "fps"}}, {"power_watts", {1.5, "W"}}}};
  }
  // What the store says to a file of these bytes, which must stay as they are.
  std::string refusal(const std::string& bytes) {
    write_file_whole(folder_ / "file", bytes);
    std::string message = "accepted";
    try {
      const Store store(folder_ / "file");
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(read_text_file(folder_ / "file"), bytes);
    return message;
  }
  // The bytes of a database on which this was run.
  [[nodiscard]] std::string database(const char* sql) const {
    const fs::path path = folder_ / "other.sqlite";
    sqlite3* connection = nullptr;
    sqlite3_open(path.c_str(), &connection);
    sqlite3_exec(connection, sql, nullptr, nullptr, nullptr);
    sqlite3_close(connection);
    return read_text_file(path);
  }

  fs::path folder_;
  fs::path path_;
};

TEST_F(StoreTest, KeepsResultsAndFaults) {
  {
    Store store(path_);
    EXPECT_THAT(store.keys(), IsEmpty());
    store.put(identity("b"), result(20));
    store.put(identity("a"), {"it jumped into nowhere", {}});
  }
  const Store store(path_);
  EXPECT_THAT(store.keys(), ElementsAre("a", "b"));
  EXPECT_EQ(store.get("a", {"power_watts"}).fault, "it jumped into nowhere");
  const Result kept = store.get("b", {"frames_per_second", "absent"});
  ASSERT_EQ(kept.metrics.size(), 1U);
  EXPECT_EQ(kept.metrics.at("frames_per_second").value, 20);
  EXPECT_EQ(kept.metrics.at("frames_per_second").unit, "fps");
  EXPECT_THAT(store.metric_names(), ElementsAre("frames_per_second", "power_watts"));
  EXPECT_THAT(Store::peek(folder_ / "absent"), IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "absent"));
}

TEST_F(StoreTest, ForgetsTheOrderInWhichResultsCame) {
  const std::vector<std::vector<std::string>> orders = {{"a", "b", "c"}, {"c", "a", "b"}};
  std::vector<std::string> bytes;
  for (const std::vector<std::string>& order : orders) {
    const fs::path path = folder_ / (order[0] + ".sqlite");
    Store store(path);
    for (const std::string& key : order) {
      Result more = result(key[0]);
      more.metrics["only." + key] = {1, "events"};
      store.put(identity(key), more);
    }
    store.finish();
    bytes.push_back(read_text_file(path));
  }
  EXPECT_EQ(bytes[0], bytes[1]);
  Store again(folder_ / "a.sqlite");
  EXPECT_EQ(again.get("b", {"only.b"}).metrics.size(), 1U);
  again.finish();
  EXPECT_EQ(read_text_file(folder_ / "a.sqlite"), bytes[0]);
  EXPECT_FALSE(fs::exists(folder_ / "a.sqlite-journal"));
}

TEST_F(StoreTest, BelongsToOneExplorationAtATime) {
  const Store first(path_);
  try {
    const Store second(path_);
    ADD_FAILURE() << "two write to one file";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("another finback explore works on it"));
  }
  EXPECT_THAT(Store::peek(path_), IsEmpty());  // others may look
}

TEST_F(StoreTest, WaitsForNobodyWhoWrites) {
  { const Store made(path_); }
  sqlite3* other = nullptr;
  sqlite3_open(path_.c_str(), &other);
  sqlite3_exec(other, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr);
  EXPECT_THROW(
      {
        try {
          const Store store(path_);
        } catch (const InputError& error) {
          EXPECT_THAT(error.what(), HasSubstr("is locked by another program"));
          throw;
        }
      },
      InputError);
  sqlite3_close(other);
  const Store free(path_);
}

TEST_F(StoreTest, RefusesWhatIsNotItsOwnAndLeavesItAlone) {
  EXPECT_THAT(refusal("hello"), HasSubstr("is no SQLite database"));
  EXPECT_THAT(refusal(std::string(100000, 'x')), HasSubstr("is no SQLite database"));
  EXPECT_THAT(refusal(database("CREATE TABLE runs (key TEXT)")),
              HasSubstr("is the database of another program"));
  EXPECT_THAT(refusal(database("PRAGMA application_id = 1178748248; PRAGMA user_version = 99;")),
              HasSubstr("has schema 99"));
}

TEST_F(StoreTest, RefusesADamagedFile) {
  {
    Store store(path_);
    for (int i = 0; i < 10; ++i) {
      store.put(identity(fmt::format("{:03}", i)), result(i));
    }
    store.finish();
  }
  std::string bytes = read_text_file(path_);
  std::fill(bytes.begin() + 4096, bytes.end(), 'x');
  EXPECT_THAT(refusal(bytes), HasSubstr("is a damaged database"));
}

TEST_F(StoreTest, SaysWhereItCannotWrite) {
  write_file_whole(folder_ / "taken", "");
  EXPECT_THROW(Store(folder_ / "taken" / "space.sqlite"), InputError);
  EXPECT_THROW(Store{folder_}, InputError);
  EXPECT_THROW(Store("/proc/space.sqlite"), InputError);
}

}  // namespace
}  // namespace finback::explorer
