// The same file is read by tests/contract/test_golden.py: both languages agree on what stands where.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "places.h"
#include "serve/image.h"
#include "states.h"

namespace tripoint {
namespace {

using namespace tripoint::test;

TEST(GoldenTest, ThePositionReadsAsTheContractSays) {
  std::ifstream file(test::top_folder() / "firmware/contract/golden/position.json");
  ASSERT_TRUE(file.is_open());
  const auto golden = nlohmann::json::parse(file)["registers"];
  ASSERT_GE(golden.size(), 30U);
  const RegisterImage image = image_at(edition_of(unit_state()), ServiceState{}, kExposed + milliseconds(12));
  for (const auto& row : golden) {
    const std::size_t address = row["address"];
    const auto words = row["words"].get<std::vector<std::uint16_t>>();
    for (std::size_t i = 0; i < words.size(); ++i) {
      EXPECT_EQ(image[address + i], words[i]) << row["name"];
      EXPECT_EQ(image[kMirrorOrder[address + i]], words[words.size() - 1 - i]) << "mirror of " << row["name"];
    }
  }
}

}  // namespace
}  // namespace tripoint
