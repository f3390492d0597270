#include <components/host_monitor/host_text.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace host {
namespace {

constexpr std::string_view kStat =
    "cpu  65184 10 20229 293174 2256 0 454 260 0 0\n"
    "cpu0 29973 4 8253 152246 146 0 25 121 0 0\n"
    "cpu1 35211 6 11975 140928 2110 0 429 139 0 0\n"
    "intr 1112295 0 0 1 15\n"
    "ctxt 2018523\n"
    "btime 1700000000\n";

TEST(ParseCpu, CountsAllTimeExceptIdleAndIoWaitAsBusy) {
  const CpuCounters counters = ParseCpu(kStat);

  EXPECT_EQ(counters.total.busy, 65184U + 10 + 20229 + 454 + 260);
  EXPECT_EQ(counters.total.all, counters.total.busy + 293174 + 2256);
  ASSERT_EQ(counters.cores.size(), 2U);
  EXPECT_EQ(counters.cores[1].busy, 35211U + 6 + 11975 + 429 + 139);
}

TEST(ParseCpu, DoesNotCountGuestsTwice) {
  const CpuCounters counters = ParseCpu("cpu 100 20 30 400 0 0 0 0 70 15\n");

  EXPECT_EQ(counters.total.busy, 150U);
  EXPECT_EQ(counters.total.all, 550U);
}

TEST(ParseCpu, AcceptsTheFewerColumnsOfOldKernels) {
  const CpuCounters counters = ParseCpu("cpu 100 20 30 400\n");

  EXPECT_EQ(counters.total.busy, 150U);
  EXPECT_EQ(counters.total.all, 550U);
}

TEST(ParseCpu, AnOfflineCoreKeepsItsIndex) {
  const CpuCounters counters = ParseCpu("cpu 1 0 0 1\ncpu0 1 0 0 1\ncpu3 9 0 0 1\n");

  ASSERT_EQ(counters.cores.size(), 4U);
  EXPECT_EQ(counters.cores[1].all, 0U);
  EXPECT_EQ(counters.cores[3].busy, 9U);
}

TEST(ParseCpu, IgnoresAnAbsurdCoreNumber) {
  EXPECT_TRUE(ParseCpu("cpu4000000000 1 2 3 4\ncpux 1 2 3 4\ncpu-1 1 1 1 1\n").cores.empty());
}

TEST(ParseMemory, UsedIsTotalMinusAvailable) {
  const Memory memory = ParseMemory(
      "MemTotal:       24684084 kB\n"
      "MemFree:        23571432 kB\n"
      "MemAvailable:   23779344 kB\n"
      "Buffers:            5032 kB\n"
      "Cached:           342852 kB\n"
      "SwapTotal:       2097152 kB\n"
      "SwapFree:        1048576 kB\n");

  EXPECT_DOUBLE_EQ(memory.total, 24684084 / 1024.0);
  EXPECT_DOUBLE_EQ(memory.used, (24684084 - 23779344) / 1024.0);
  EXPECT_DOUBLE_EQ(memory.swap, 1024.0);
}

TEST(ParseMemory, EstimatesAvailableMemoryOnOldKernels) {
  const Memory memory = ParseMemory(
      "MemTotal: 1048576 kB\nMemFree: 524288 kB\nBuffers: 102400 kB\nCached: 102400 kB\n");

  EXPECT_DOUBLE_EQ(memory.used, 1024.0 - 512.0 - 200.0);
}

TEST(ParseMemory, IsNeverNegative) {
  const Memory memory = ParseMemory("MemTotal: 10 kB\nMemAvailable: 20 kB\nSwapFree: 5 kB\n");

  EXPECT_EQ(memory.used, 0.0);
  EXPECT_EQ(memory.swap, 0.0);
}

TEST(ParseDisks, AddsWholeDisksOnly) {
  const DiskCounters disks = ParseDisks(
      "   7       0 loop0 10 0 1000 0 0 0 0 0 0 0 0\n"
      " 259       0 nvme0n1 228747 32340 2000 154319 246747 46708 4000 35174 0 42956 197265\n"
      " 259       1 nvme0n1p1 200 0 1900 0 0 0 3900 0 0 0 0\n"
      "   8       0 sda 5 0 100 0 5 0 300 0 0 0 0 0 0 0 0\n"
      "   8       1 sda1 5 0 100 0 5 0 300 0 0 0 0\n"
      "   8      16 sdaa 1 0 10 0 1 0 20 0 0 0 0\n"
      " 253       0 dm-0 5 0 7777 0 5 0 7777 0 0 0 0\n"
      " 252       0 zram0 5 0 7777 0 5 0 7777 0 0 0 0\n");

  EXPECT_EQ(disks.read, (2000U + 100 + 10) * 512);
  EXPECT_EQ(disks.written, (4000U + 300 + 20) * 512);
}

TEST(ParseDisks, CountsDisksWhoseNameEndsInADigit) {
  const DiskCounters disks = ParseDisks(
      "179 0 mmcblk0 1 0 10 0 1 0 1 0\n"
      "179 8 mmcblk01 1 0 20 0 1 0 2 0\n"
      "179 1 mmcblk0p1 1 0 40 0 1 0 4 0\n");

  EXPECT_EQ(disks.read, 30U * 512);
}

TEST(ParseNetwork, AddsPhysicalInterfacesAndKeepsLoopbackSeparate) {
  const NetworkCounters network = ParseNetwork(
      "Inter-|   Receive                                                |  Transmit\n"
      " face |bytes    packets errs drop fifo frame compressed multicast|bytes    packets errs\n"
      "    lo:  203467    4033    0    0    0     0          0         0   203467    4033    0\n"
      "  eth0: 491772036   11210    0    0    0     0          0         0   558585    7053    0\n"
      " wlan0:1000 1 0 0 0 0 0 0 2000 1 0 0 0 0 0 0\n"
      "docker0: 9999 1 0 0 0 0 0 0 9999 1 0 0 0 0 0 0\n"
      "  ifb0:       0       0    0    0    0     0          0         0        0       0    0\n");

  EXPECT_EQ(network.received, 491772036U + 1000);
  EXPECT_EQ(network.sent, 558585U + 2000);
  EXPECT_EQ(network.loopback, 203467U);
}

TEST(ParseTemperature, ReadsThousandthsOfADegree) {
  EXPECT_EQ(ParseTemperature("45250\n"), 45.25);
  EXPECT_EQ(ParseTemperature("-5000"), -5.0);
}

TEST(ParseTemperature, RejectsTextThatIsNoTemperature) {
  EXPECT_EQ(ParseTemperature(""), std::nullopt);
  EXPECT_EQ(ParseTemperature("N/A\n"), std::nullopt);
  EXPECT_EQ(ParseTemperature("12x\n"), std::nullopt);
  EXPECT_EQ(ParseTemperature("65535000\n"), std::nullopt);
  EXPECT_EQ(ParseTemperature("-274000\n"), std::nullopt);
  EXPECT_EQ(ParseTemperature("99999999999999999999999\n"), std::nullopt);
}

TEST(HostText, AnEmptyTextGivesNoCounters) {
  EXPECT_EQ(ParseCpu("").total.all, 0U);
  EXPECT_EQ(ParseMemory("").total, 0.0);
  EXPECT_EQ(ParseDisks("").read, 0U);
  EXPECT_EQ(ParseNetwork("").received, 0U);
}

TEST(HostText, ParsersSurviveRandomText) {
  std::mt19937 random(3);
  const std::string_view alphabet = "cpu0 sda:lo\n\t\r-99999999999999999999999MemTotal: eth";
  std::uniform_int_distribution<std::size_t> letter(0, alphabet.size() - 1);

  for (int i = 0; i < 3000; ++i) {
    std::string text(static_cast<std::size_t>(i % 200), ' ');
    for (char& c : text) c = alphabet[letter(random)];
    EXPECT_LE(ParseCpu(text).cores.size(), 4096U);
    EXPECT_GE(ParseMemory(text).used, 0.0);
    (void)ParseDisks(text);
    (void)ParseNetwork(text);
    (void)ParseTemperature(text);
  }
}

TEST(HostText, ParsersSurviveTruncatedText) {
  for (std::size_t size = 0; size <= kStat.size(); ++size) {
    EXPECT_LE(ParseCpu(kStat.substr(0, size)).cores.size(), 2U);
  }
}

}  // namespace
}  // namespace host
