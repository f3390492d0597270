#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "gcm_console/system_fixture.h"

namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// A component with numbers that no double can represent, states, and unusual floats.
class ValuesTest : public SystemFixture {
 protected:
  void SetUp() override {
    StartGcm();
    track = StartOne("track", "odometer", "Odometer", "odometer");
    ASSERT_TRUE(EventuallySays({"get", table + "Last"}, "18446744073709551615")) << track->err();
  }

  /// Returns the output of `gcm get`, without the end of the line.
  [[nodiscard]] std::string Get(const std::string& member) const {
    const Outcome outcome = Gcm({"get", table + member});
    EXPECT_EQ(outcome.exit_code, program::kOk) << outcome.err;
    return outcome.out.substr(0, outcome.out.find('\n'));
  }

  const std::string table = "track/odometer/state.";
  std::unique_ptr<Program> track;
};

std::vector<std::string> RowsIn(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  return all;
}

/// Returns the bits of the double that strtod() reads from a text.
std::uint64_t BitsIn(const std::string& text) {
  return std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr));
}

TEST_F(ValuesTest, IntegersAreExactInEveryForm) {
  EXPECT_EQ(Get("Last"), "18446744073709551615");
  EXPECT_THAT(Gcm({"get", table + "Last", "--json"}).out,
              HasSubstr("\"value\": 18446744073709551615"));

  const Outcome watched =
      Gcm({"--json", "watch", table + "Count", table + "Stamp", table + "Last", "--count", "20"});
  ASSERT_EQ(watched.exit_code, program::kOk) << watched.err;
  std::map<std::uint64_t, std::uint64_t> counts;
  for (const std::string& line : RowsIn(watched.out)) {
    const json row = json::parse(line);
    const auto& values = row["values"];
    EXPECT_THAT(line, HasSubstr("\"" + table + "Last\":18446744073709551615"));
    EXPECT_EQ(values[table + "Stamp"].get<std::int64_t>() % 10'000'000, 1) << line;
    EXPECT_GT(values[table + "Count"].get<std::uint64_t>(), std::uint64_t{1} << 53U) << line;
    counts[row["tick"].get<std::uint64_t>()] = values[table + "Count"].get<std::uint64_t>();
  }
  ASSERT_EQ(counts.size(), 20U);
  const auto& [first_tick, first] = *counts.begin();
  for (const auto& [tick, count] : counts) EXPECT_EQ(count - first, tick - first_tick);
}

TEST_F(ValuesTest, FloatsReadBackAsTheSameBits) {
  EXPECT_EQ(Get("Edges"),
            "{\"zero\":-0.0,\"none\":\"nan\",\"endless\":\"-inf\","
            "\"largest\":1.7976931348623157e+308,\"smallest\":5e-324,"
            "\"sum\":0.30000000000000004,\"single\":0.1,\"uptime\":2000000000.123456789}");

  for (const auto& [field, value] :
       std::map<std::string, double>{{"zero", -0.0},
                                     {"largest", std::numeric_limits<double>::max()},
                                     {"smallest", std::numeric_limits<double>::denorm_min()},
                                     {"sum", 0.1 + 0.2}}) {
    const std::string member = "Edges." + field;
    EXPECT_EQ(BitsIn(Get(member)), std::bit_cast<std::uint64_t>(value)) << field;
    const json row = json::parse(Gcm({"--json", "watch", table + member, "--count", "1"}).out);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(row["values"][table + member].get<double>()),
              std::bit_cast<std::uint64_t>(value))
        << field;
  }
}

TEST_F(ValuesTest, NanAndInfinityHaveOneForm) {
  EXPECT_EQ(Get("Edges.none"), "\"nan\"");
  EXPECT_EQ(Get("Edges.endless"), "\"-inf\"");
  const Outcome watched =
      Gcm({"--json", "watch", table + "Edges.none", table + "Edges.endless", "--count", "1"});
  const json row = json::parse(watched.out);
  EXPECT_EQ(row["values"][table + "Edges.none"], "nan");
  EXPECT_EQ(row["values"][table + "Edges.endless"], "-inf");
  EXPECT_THAT(Gcm({"watch", table + "Edges.none", "--count", "1"}).out, HasSubstr("\t\"nan\"\n"));
}

TEST_F(ValuesTest, DurationsKeepTheirNanoseconds) {
  EXPECT_EQ(Get("Edges.uptime"), "2000000000.123456789");
  EXPECT_THAT(Gcm({"watch", table + "Edges.uptime", "--count", "1"}).out,
              HasSubstr("\t2000000000.123456789\n"));
}

TEST_F(ValuesTest, StatesHaveTheirNamesInEveryRow) {
  const Outcome watched =
      Gcm({"--json", "watch", table + "Mode", table + "Ready", "--count", "100"});
  ASSERT_EQ(watched.exit_code, program::kOk) << watched.err;
  std::set<std::string> modes;
  for (const std::string& line : RowsIn(watched.out)) {
    const json row = json::parse(line);
    EXPECT_TRUE(row["values"][table + "Ready"].is_boolean()) << line;
    modes.insert(row["values"][table + "Mode"].get<std::string>());
  }
  EXPECT_THAT(modes, ElementsAre("fault", "idle", "moving"));
}

TEST_F(ValuesTest, WritesIntegersExactly) {
  constexpr const char* kCount = "18446744073708503039";  // an odd number far beyond 2^53
  const Outcome called = Gcm({"call", "track/odometer/Control.SetCount", kCount});
  ASSERT_EQ(called.exit_code, program::kOk) << called.err;

  const auto count = [&] { return std::stoull(Get("Count")); };
  EXPECT_TRUE(EventuallyTrue([&] { return count() > std::stoull(kCount); }));
  EXPECT_LT(count() - std::stoull(kCount), 1U << 20U);
}

TEST_F(ValuesTest, APlotNamesStatesAndPrintsWholeCounters) {
  const Outcome plotted = Gcm({"plot", table + "Mode", table + "Ready", table + "Count",
                               table + "Edges.none", "--window", "2s", "--for", "3s"});
  ASSERT_EQ(plotted.exit_code, program::kOk) << plotted.err;

  for (const char* label : {"moving  ", "idle  ", "fault  ", "true  ", "false  "}) {
    EXPECT_THAT(plotted.out, HasSubstr(label));
  }
  EXPECT_THAT(plotted.out, testing::ContainsRegex(table + "Mode = (moving|idle|fault)\n"));
  EXPECT_THAT(plotted.out, testing::ContainsRegex(table + "Count = 90071992547[0-9]+\n"));
  EXPECT_THAT(plotted.out, HasSubstr(table + "Edges.none = nan\n"));
  std::set<std::string> counts;
  for (const std::string& line : RowsIn(plotted.out)) {
    if (!line.starts_with("900719925")) continue;
    EXPECT_TRUE(counts.insert(line.substr(0, line.find(' '))).second) << line;
  }
  EXPECT_GE(counts.size(), 2U) << plotted.out;
}

}  // namespace
