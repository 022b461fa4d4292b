#include "document/toml_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using ::testing::HasSubstr;

const TomlTable& table_in(const TomlTable& table, std::string_view key) {
  return std::get<TomlTable>(find(table, key)->value);
}

TEST(TomlTreeTest, ValuesKeepTheirTypeAndLine) {
  const TomlTable tree = toml_tree_from("a = 1\nb = 2.5\n\nc = \"x\"\nd = true\n[t]\ne = [1, 2]\n", "f.toml").value();
  EXPECT_EQ(std::get<std::int64_t>(find(tree, "a")->value), 1);
  EXPECT_EQ(std::get<double>(find(tree, "b")->value), 2.5);
  EXPECT_EQ(std::get<std::string>(find(tree, "c")->value), "x");
  EXPECT_TRUE(std::get<bool>(find(tree, "d")->value));
  EXPECT_EQ(std::get<TomlArray>(find(table_in(tree, "t"), "e")->value).size(), 2U);
  EXPECT_EQ(find(tree, "c")->line, 4);
  EXPECT_EQ(find(table_in(tree, "t"), "e")->line, 7);
}

TEST(TomlTreeTest, AnAbsentKeyIsNothing) { EXPECT_EQ(find(toml_tree_from("a = 1", "").value(), "b"), nullptr); }

TEST(TomlTreeTest, TimesAreUtcWhateverTheirOffset) {
  const TomlTable tree = toml_tree_from("a = 1970-01-02T00:00:10Z\nb = 1970-01-02T01:30:10+01:30\n", "").value();
  EXPECT_EQ(std::get<UtcSecond>(find(tree, "a")->value), UtcSecond{std::chrono::seconds{86410}});
  EXPECT_EQ(std::get<UtcSecond>(find(tree, "b")->value), UtcSecond{std::chrono::seconds{86410}});
}

TEST(TomlTreeTest, BrokenTextIsAnErrorWithFileAndLine) {
  const auto tree = toml_tree_from("a = 1\nb = = 2\n", "f.toml");
  ASSERT_FALSE(tree.has_value());
  EXPECT_EQ(tree.error().code, ErrorCode::kMalformed);
  EXPECT_THAT(tree.error().message, HasSubstr("f.toml:2: not TOML"));
}

TEST(TomlTreeTest, LettersBeyondAsciiAreTextAndNeverWhiteSpace) {
  // From every block of the library's table of spaces that has no space of its own.
  for (const char* letter : {"\u00e4", "\u00b5", "\u0391", "\u1681", "\u2060", "\u2c00", "\ufe80", "\uff21"}) {
    const std::string text = "a = \"" + std::string{letter} + "\"  # " + letter + "\n";
    const auto tree = toml_tree_from(text, "f.toml");
    ASSERT_TRUE(tree.has_value()) << text;
    EXPECT_EQ(std::get<std::string>(find(*tree, "a")->value), letter);
    EXPECT_FALSE(toml_tree_from("a = 1 " + std::string{letter}, "f.toml").has_value()) << text;
  }
}

TEST(TomlTreeTest, TextThatTheParserDidNotExpectIsAnError) {
  const auto tree = toml_tree_from("[+]\n", "f.toml");
  ASSERT_FALSE(tree.has_value());
  EXPECT_EQ(tree.error().code, ErrorCode::kMalformed);
}

TEST(TomlTreeTest, ADateAloneIsAnError) {
  EXPECT_EQ(toml_tree_from("a = 1970-01-02", "").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(toml_tree_from("a = [{b = 07:30:00}]", "").error().code, ErrorCode::kMalformed);
}

TEST(TomlTreeTest, TextOverTheLimitIsAnError) {
  const std::string comment(kMostDocumentBytes, '#');
  EXPECT_TRUE(toml_tree_from(comment, "").has_value());
  EXPECT_EQ(toml_tree_from(comment + "#", "").error().code, ErrorCode::kMalformed);
}

TEST(TomlTreeTest, AnOverrideReplacesAValue) {
  const TomlTable tree = with_override(toml_tree_from("[t]\na = 1\n", "").value(), "t.a=2").value();
  EXPECT_EQ(std::get<std::int64_t>(find(table_in(tree, "t"), "a")->value), 2);
  EXPECT_EQ(find(table_in(tree, "t"), "a")->line, 0);
}

TEST(TomlTreeTest, AnOverrideMakesTheTablesItNeeds) {
  const TomlTable tree = with_override({}, "a.b.c=[1, 2]").value();
  EXPECT_EQ(std::get<TomlArray>(find(table_in(table_in(tree, "a"), "b"), "c")->value).size(), 2U);
}

TEST(TomlTreeTest, AnOverrideWithoutQuotesIsText) {
  const TomlTable tree = with_override({}, "t.port=1-1.2").value();
  EXPECT_EQ(std::get<std::string>(find(table_in(tree, "t"), "port")->value), "1-1.2");
}

TEST(TomlTreeTest, AnOverrideCannotSmuggleInASecondKey) {
  const TomlTable tree = with_override({}, "a=1\nb = 2").value();
  EXPECT_EQ(find(tree, "b"), nullptr);
}

TEST(TomlTreeTest, AnOverrideThatIsNoAssignmentIsAnError) {
  const TomlTable tree = toml_tree_from("a = 1", "").value();
  for (const char* bad : {"", "a", "=1", ".a=1", "t.=1", "t..a=1", "a.b=1"}) {
    const auto result = with_override(tree, bad);
    ASSERT_FALSE(result.has_value()) << bad;
    EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
    EXPECT_THAT(result.error().message, HasSubstr("table.key=value"));
  }
}

}  // namespace
}  // namespace tripoint
