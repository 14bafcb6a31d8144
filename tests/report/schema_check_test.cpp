// The checker itself: each keyword has a document that breaks it.
#include "schema_check.hpp"

#include <gtest/gtest.h>

namespace finback::report {
namespace {

using nlohmann::json;

const json kSchema = json::parse(R"({
  "type": "object", "required": ["count"], "additionalProperties": false,
  "properties": {
    "count": { "$ref": "#/$defs/count" },
    "kind": { "enum": ["a", "b"] },
    "name": { "type": ["string", "null"], "pattern": "^x" },
    "list": { "type": "array", "items": { "type": "number", "maximum": 5 } },
    "version": { "const": 1 }
  },
  "$defs": { "count": { "type": "integer", "minimum": 0 } }
})");

TEST(SchemaCheck, AcceptsWhatFits) {
  const json document =
      json::parse(R"({"count": 3, "kind": "a", "name": null, "list": [1, 2.5], "version": 1})");
  EXPECT_EQ(schema_complaints(kSchema, document), std::vector<std::string>{});
}

TEST(SchemaCheck, RefusesWhatDoesNot) {
  for (const char* document : {R"([])", R"({})", R"({"count": -1})", R"({"count": 1.5})",
                               R"({"count": 1, "kind": "c"})", R"({"count": 1, "name": "y"})",
                               R"({"count": 1, "name": 7})", R"({"count": 1, "list": [6]})",
                               R"({"count": 1, "version": 2})", R"({"count": 1, "other": 2})"}) {
    EXPECT_EQ(schema_complaints(kSchema, json::parse(document)).size(), 1U) << document;
  }
}

TEST(SchemaCheck, ComplainsOfKeywordsItDoesNotKnow) {
  EXPECT_EQ(schema_complaints(json::parse(R"({"minLength": 2})"), json("x")).size(), 1U);
}

}  // namespace
}  // namespace finback::report
