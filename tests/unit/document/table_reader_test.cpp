#include "document/table_reader.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tripoint {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The error of reading a text in a certain way; an empty message when there is none.
Error error_of(std::string_view text, const std::function<void(TableReader&)>& read) {
  const TomlTable tree = toml_tree_from(text, "f.toml").value();
  Findings findings{"f.toml"};
  TableReader reader{findings, tree};
  read(reader);
  return findings.error().value_or(Error{ErrorCode::kMalformed, ""});
}

std::string message_of(std::string_view text, const std::function<void(TableReader&)>& read) {
  return error_of(text, read).message;
}

TEST(TableReaderTest, GoodValuesComeThrough) {
  const auto read = [](TableReader& t) {
    EXPECT_EQ(t.number("a", {0.0, 2.0}), 1.5);
    EXPECT_EQ(t.integer("b", {0, 2}), 2);
    EXPECT_TRUE(t.truth("c"));
    EXPECT_EQ(t.text("d"), "x");
    EXPECT_THAT(t.numbers("e", 2, {0.0, 9.0}), ElementsAre(1.0, 2.0));
    EXPECT_THAT(t.texts("f"), ElementsAre("y", "z"));
    t.finish();
  };
  EXPECT_EQ(message_of("a = 1.5\nb = 2\nc = true\nd = \"x\"\ne = [1, 2.0]\nf = [\"y\", \"z\"]\n", read), "");
}

TEST(TableReaderTest, AbsentKeysTakeTheirDefaults) {
  const auto read = [](TableReader& t) {
    EXPECT_EQ(t.number("a", {0.0, 2.0}, 1.5), 1.5);
    EXPECT_EQ(t.integer("b", {0, 2}, 2), 2);
    EXPECT_TRUE(t.truth("c", true));
    EXPECT_EQ(t.text("d", "x"), "x");
    EXPECT_TRUE(t.texts("e").empty());
    EXPECT_EQ(t.table("t").integer("b", {0, 2}, 1), 1);
    EXPECT_TRUE(t.tables("ts").empty());
    EXPECT_FALSE(t.time("when").has_value());
  };
  EXPECT_EQ(message_of("", read), "");
}

TEST(TableReaderTest, AMissingKeyIsNamedWithItsTable) {
  const Error error = error_of("\n[t]\nb = 1\n", [](TableReader& t) { t.table("t").number("a", {}); });
  EXPECT_EQ(error.code, ErrorCode::kMissingKey);
  EXPECT_EQ(error.message, "f.toml:2: t.a is missing: permitted is a number");
}

TEST(TableReaderTest, AValueOutOfRangeNamesFileLineKeyAndRange) {
  const Error error = error_of("\na = 3\n", [](TableReader& t) { t.number("a", {0.0, 2.5}); });
  EXPECT_EQ(error.code, ErrorCode::kOutOfRange);
  EXPECT_EQ(error.message, "f.toml:2: a = 3: permitted is a number from 0 to 2.5");
}

TEST(TableReaderTest, BothEndsOfARangeArePermitted) {
  for (const char* text : {"a = 1", "a = 5"}) {
    EXPECT_EQ(message_of(text, [](TableReader& t) { t.integer("a", {1, 5}); }), "");
  }
  for (const char* text : {"a = 0", "a = 6"}) {
    EXPECT_NE(message_of(text, [](TableReader& t) { t.integer("a", {1, 5}); }), "");
  }
}

TEST(TableReaderTest, NumbersThatAreNoneAreRefused) {
  for (const char* text : {"a = nan", "a = inf", "a = -inf", "a = \"1\"", "a = true"}) {
    EXPECT_NE(message_of(text, [](TableReader& t) { t.number("a", {-1e300, 1e300}); }), "") << text;
  }
}

TEST(TableReaderTest, OtherTypesAreRefusedByNameOfTheRightOne) {
  EXPECT_THAT(message_of("a = 1.5", [](TableReader& t) { t.integer("a", {0, 9}); }), HasSubstr("a whole number"));
  EXPECT_THAT(message_of("a = 1", [](TableReader& t) { t.truth("a"); }), HasSubstr("true or false"));
  EXPECT_THAT(message_of("a = 1", [](TableReader& t) { t.text("a"); }), HasSubstr("text in quotes"));
  EXPECT_THAT(message_of("a = \"b\\nc\"", [](TableReader& t) { t.text("a"); }), HasSubstr("one line"));
  EXPECT_THAT(message_of("a = 1", [](TableReader& t) { t.texts("a"); }), HasSubstr("list of texts"));
  EXPECT_THAT(message_of("a = [1]", [](TableReader& t) { t.texts("a"); }), HasSubstr("list of texts"));
  EXPECT_THAT(message_of("a = 1", [](TableReader& t) { t.table("a"); }), HasSubstr("a table [a]"));
  EXPECT_THAT(message_of("a = [1]", [](TableReader& t) { t.tables("a"); }), HasSubstr("tables, each begun by [[a]]"));
  EXPECT_THAT(message_of("a = \"x\"", [](TableReader& t) { t.time("a"); }), HasSubstr("date and time"));
}

TEST(TableReaderTest, AListMustHaveItsLength) {
  for (const char* text : {"a = [1]", "a = [1, 2, 3]", "a = 1", "a = [1, \"2\"]", "a = [[1], [[2]]]", "a = [1, 20]"}) {
    EXPECT_THAT(message_of(text,
                           [](TableReader& t) {
                             t.numbers("a", 2, {0.0, 9.0});
                           }),
                HasSubstr("2 numbers"))
        << text;
  }
}

TEST(TableReaderTest, AListOfRowsCountsAsItsNumbers) {
  const auto read = [](TableReader& t) { EXPECT_THAT(t.numbers("a", 4, {}), ElementsAre(1, 2, 3, 4)); };
  EXPECT_EQ(message_of("a = [[1, 2], [3, 4]]", read), "");
}

TEST(TableReaderTest, AWordMustBeOneOfTheChoices) {
  const auto read = [](TableReader& t) { EXPECT_EQ((t.choice<int>("a", {{"one", 1}, {"two", 2}})), 2); };
  EXPECT_EQ(message_of("a = \"two\"", read), "");
  const auto wrong = [](TableReader& t) { t.choice<int>("a", {{"one", 1}, {"two", 2}}); };
  EXPECT_EQ(message_of("a = \"three\"", wrong), "f.toml:1: a = \"three\": permitted is \"one\" or \"two\"");
}

TEST(TableReaderTest, ARefusedListIsShownAsItIsWritten) {
  const auto read = [](TableReader& t) { t.numbers("a", 2, {0.0, 9.0}); };
  EXPECT_EQ(message_of("a = [1, \"x\", [2]]", read),
            "f.toml:1: a = [1, \"x\", [2]]: permitted is 2 numbers from 0 to 9");
  std::string long_list = "a = [1";
  for (int i = 0; i < 100; ++i) long_list += ", 1";
  EXPECT_THAT(message_of(long_list + "]", read), HasSubstr("1, ...]: permitted is 2 numbers"));
}

TEST(TableReaderTest, AMisspeltKeyExplainsTheOneThatIsMissing) {
  const auto read = [](TableReader& t) {
    t.number("volume", {});
    t.finish();
  };
  EXPECT_EQ(message_of("volumen = 1", read), "f.toml:1: unknown key volumen (did you mean volume?)");
}

TEST(TableReaderTest, ATableIsNoValue) {
  const auto read = [](TableReader& t) { t.number("a", {0.0, 9.0}); };
  EXPECT_EQ(message_of("[a]", read), "f.toml:1: a is a table: permitted is a number from 0 to 9");
  EXPECT_EQ(message_of("[[a]]", read), "f.toml:1: a is a list of tables: permitted is a number from 0 to 9");
}

TEST(TableReaderTest, AnUnknownKeyIsAnErrorWithTheNearestKnownOne) {
  const auto read = [](TableReader& t) {
    t.integer("width_px", {0, 9}, 1);
    t.integer("height_px", {0, 9}, 1);
    t.finish();
  };
  const Error error = error_of("\nheigth_px = 1\n", read);
  EXPECT_EQ(error.code, ErrorCode::kUnknownKey);
  EXPECT_EQ(error.message, "f.toml:2: unknown key heigth_px (did you mean height_px?)");
}

TEST(TableReaderTest, AnUnknownKeyLikeNoOtherListsThePermittedOnes) {
  const auto read = [](TableReader& t) {
    t.integer("a", {0, 9}, 1);
    t.integer("b", {0, 9}, 1);
    t.finish();
  };
  EXPECT_EQ(message_of("something = 1", read), "f.toml:1: unknown key something; permitted is a, b");
}

TEST(TableReaderTest, OtherKeysPassWhereTheyAreAllowed) {
  const auto read = [](TableReader& t) {
    t.allow_other_keys();
    t.finish();
  };
  EXPECT_EQ(message_of("something = 1", read), "");
}

TEST(TableReaderTest, TheFirstErrorIsTheOneThatCounts) {
  const auto read = [](TableReader& t) {
    t.integer("b", {0, 1});
    t.integer("a", {0, 1});
  };
  EXPECT_THAT(message_of("a = 5\nb = 6\n", read), HasSubstr("b = 6"));
}

TEST(TableReaderTest, TablesOfAListAreNamedByTheirPlace) {
  const auto read = [](TableReader& t) {
    for (TableReader& item : t.tables("p")) item.integer("id", {0, 9});
  };
  EXPECT_EQ(message_of("[[p]]\nid = 1\n[[p]]\nid = 10\n", read),
            "f.toml:4: p[1].id = 10: permitted is a whole number from 0 to 9");
}

TEST(TableReaderTest, OnTheCommandLineTextNeedsNoQuotes) {
  const TomlTable tree = with_override({}, "serial=0012").value();
  const TomlTable number = with_override({}, "serial=12").value();
  Findings findings{"f.toml"};
  EXPECT_EQ((TableReader{findings, tree}.text("serial")), "0012");
  EXPECT_EQ((TableReader{findings, number}.text("serial")), "12");
  EXPECT_FALSE(findings.error().has_value());
}

TEST(TableReaderTest, AnErrorOnTheCommandLineSaysSo) {
  const TomlTable tree = with_override({}, "a=9").value();
  Findings findings{"f.toml"};
  TableReader{findings, tree}.integer("a", {0, 5});
  EXPECT_EQ(findings.error()->message, "f.toml with --set: a = 9: permitted is a whole number from 0 to 5");
}

TEST(TableReaderTest, ValuesAreNotedWhetherWrittenOrNot) {
  const TomlTable tree = toml_tree_from("b = 2.50", "").value();
  Findings findings{""};
  TableReader reader{findings, tree};
  reader.number("b", {});
  reader.integer("a", {}, 7);
  EXPECT_THAT(findings.values(), ElementsAre("a = 7", "b = 2.5"));
}

}  // namespace
}  // namespace tripoint
