#include <gtest/gtest.h>
#include <support/machine/sanitized.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "targets.h"

/// Every test run feeds the decoders with the corpus and with random changes of it. The fuzzer
/// itself (target `fuzz`) searches longer.
namespace fuzz {

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

namespace fs = std::filesystem;

using Body = std::vector<std::byte>;

Body Read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(stream), {}};
  const auto bytes = std::as_bytes(std::span(content));
  return {bytes.begin(), bytes.end()};
}

std::vector<Body> Corpus(std::string_view target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(TENDON_CORPUS) / target)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Body> corpus;
  for (const fs::path& file : files) corpus.push_back(Read(file));
  return corpus;
}

/// Writes a number that often breaks decoders.
void WriteLength(std::mt19937& random, Body& body) {
  constexpr std::array<std::uint32_t, 8> kLengths{0,          1,          0x7f,       0xffff,
                                                  0x20000000, 0x7fffffff, 0x80000000, 0xffffffff};
  if (body.size() < 4) return;
  const std::uint32_t length = kLengths[random() % kLengths.size()];
  const std::size_t place = random() % (body.size() - 3);
  for (std::size_t i = 0; i < 4; ++i) body[place + i] = static_cast<std::byte>(length >> (8 * i));
}

void Mutate(std::mt19937& random, const Body& other, Body& body) {
  const auto place = [&] { return static_cast<std::ptrdiff_t>(random() % (body.size() + 1)); };
  const auto from = static_cast<std::ptrdiff_t>(random() % (other.size() + 1));
  switch (random() % 6) {
    case 0:
      body.insert(body.begin() + place(), static_cast<std::byte>(random()));
      break;
    case 1:
      body.erase(body.begin() + place(), body.end());
      break;
    case 2:
      body.insert(body.begin() + place(), other.begin() + from, other.end());
      break;
    case 3:
      WriteLength(random, body);
      break;
    default:
      if (!body.empty()) body[random() % body.size()] = static_cast<std::byte>(random());
  }
}

class Replay : public testing::TestWithParam<Target> {};

std::string NameOf(const testing::TestParamInfo<Target>& target) {
  return std::string(target.param.name);
}

INSTANTIATE_TEST_SUITE_P(, Replay, testing::ValuesIn(Targets().begin(), Targets().end()), NameOf);

TEST_P(Replay, HandlesTheCorpus) {
  const auto corpus = Corpus(GetParam().corpus);

  for (const Body& body : corpus) GetParam().run(body);

  EXPECT_GE(corpus.size(), 5U);
}

/// A sanitizer makes the decoders slower, so they get fewer inputs.
int Slowdown() { return tendon::test::IsSanitized() ? 5 : 1; }

TEST_P(Replay, HandlesRandomMutationsOfTheCorpus) {
  constexpr std::size_t kMax = 4096;  // bytes
  const auto corpus = Corpus(GetParam().corpus);
  ASSERT_FALSE(corpus.empty());
  std::mt19937 random(35);

  const int rounds = GetParam().rounds / Slowdown();
  for (int round = 0; round < rounds; ++round) {
    Body body = corpus[random() % corpus.size()];
    for (auto changes = 1 + random() % 4; changes > 0; --changes) {
      Mutate(random, corpus[random() % corpus.size()], body);
    }
    body.resize(std::min(body.size(), kMax));
    GetParam().run(body);
  }
}

TEST_P(Replay, HandlesFilesTruncatedAtAnyByte) {
  constexpr std::size_t kMaxCuts = 300;
  const auto step = static_cast<std::size_t>(Slowdown());
  for (const Body& body : Corpus(GetParam().corpus)) {
    for (std::size_t size = 0; size < std::min(body.size(), kMaxCuts); size += step) {
      GetParam().run(std::span(body).first(size));
    }
  }
}

}  // namespace
}  // namespace fuzz
