#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/memory_file.h>
#include <tendon/recording/playback.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recordings.h"

namespace tendon::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr mcap::Timestamp kBegin = 1'700'000'000'000'000'000;
constexpr mcap::Timestamp kMs = 1'000'000;

/// A recording that is written by hand, in memory. Each Sync() ends a chunk.
class Script {
 public:
  mcap::ChannelId AddColumn(const std::string& path, const std::string& epoch = "1") {
    return AddChannel(path, {{kKindKey, "column"},
                             {kPathKey, path},
                             {kSchemaKey, SchemaOf<std::uint64_t>().TextWithHelp()},
                             {kEpochKey, epoch}});
  }
  mcap::ChannelId AddEvent(const std::string& path) {
    return AddChannel(path, {{kKindKey, "event"},
                             {kPathKey, path},
                             {kSchemaKey, SchemaOf<std::uint64_t>().TextWithHelp()}});
  }
  mcap::ChannelId AddCommand(const std::string& path) {
    return AddChannel(path, {{kKindKey, kCommandKind},
                             {kPathKey, path},
                             {kSchemaKey, SchemaOf<std::uint64_t>().TextWithHelp()}});
  }
  mcap::ChannelId AddOwn(const std::string& topic) {
    return AddChannel(topic, {{kKindKey, "other"}});
  }
  template <typename T>
  void Add(mcap::ChannelId channel, mcap::Timestamp time, const T& value,
           std::uint32_t sequence = 0) {
    std::vector<std::byte> encoded;
    Encode(value, encoded);
    std::vector<std::byte> data(kEncapsulationSize);
    data[1] = std::byte{1};
    data.insert(data.end(), encoded.begin(), encoded.end());
    EXPECT_TRUE(memory_.writer->Write(mcap::Message{channel, sequence, time, time, data}));
  }
  void Sync() const { EXPECT_TRUE(memory_.writer->Sync()); }
  void Close() const { EXPECT_TRUE(memory_.writer->Close()); }
  std::unique_ptr<Playback> Open() {
    Close();
    auto playback = Playback::Open(mcap::Open(memory_.disk->bytes));
    EXPECT_TRUE(playback) << (playback ? "" : playback.error().message);
    return playback ? *std::move(playback) : nullptr;
  }
  [[nodiscard]] const mcap::Buffer& bytes() const { return memory_.disk->bytes; }

 private:
  mcap::ChannelId AddChannel(const std::string& topic, std::map<std::string, std::string> about) {
    const auto schema = memory_.writer->AddSchema("uint64", kSchemaEncoding, "uint64 data");
    return *memory_.writer->AddChannel(*schema, topic, kMessageEncoding, std::move(about));
  }

  mcap::MemoryRecording memory_;
};

std::uint64_t NumberIn(mcap::ByteView body) {
  std::uint64_t number = 0;
  EXPECT_TRUE(Decode(body, number));
  return number;
}

/// Each item as a word: "Number=3 at 20", in ms since kBegin.
class Listener {
 public:
  void operator()(const PlayedItem& item) {
    std::string text;
    if (const auto* value = std::get_if<PlayedValue>(&item.content)) {
      text = LastPart(value->channel->path) + "=" + std::to_string(NumberIn(value->body));
    } else if (const auto* event = std::get_if<PlayedEvent>(&item.content)) {
      text =
          "event " + LastPart(event->channel->path) + "=" + std::to_string(NumberIn(event->value));
    } else if (const auto* log = std::get_if<RosLog>(&item.content)) {
      text = "log " + log->msg;
    } else if (const auto* loss = std::get_if<Loss>(&item.content)) {
      text = "lost " + std::to_string(loss->table);
    } else {
      text = "change " + std::get<PlayedChange>(item.content).change.process;
    }
    const auto ms = static_cast<std::int64_t>(item.time - kBegin) / static_cast<std::int64_t>(kMs);
    all.push_back(text + " at " + std::to_string(ms));
  }

  std::vector<std::string> all;

 private:
  static std::string LastPart(const std::string& path) { return path.substr(path.find('.') + 1); }
};

std::vector<std::string> Play(Playback& playback, mcap::Timestamp time) {
  Listener listener;
  playback.PlayUpTo(time, std::ref(listener));
  return listener.all;
}

std::vector<std::string> PastOf(Playback& playback, const std::vector<std::string>& columns,
                                mcap::Timestamp from,
                                Playback::WithLosses losses = Playback::WithLosses::kNo) {
  Listener listener;
  playback.Past(columns, from, losses, std::ref(listener));
  return listener.all;
}

/// Ten rows of two columns, one each 10 ms, in five chunks, and an event at 45 ms.
Script TenRows() {
  Script script;
  const auto number = script.AddColumn("robot/arm/state.Number");
  const auto other = script.AddColumn("robot/arm/state.Other");
  const auto reached = script.AddEvent("robot/arm/Control.Reached");
  for (std::uint32_t i = 0; i < 10; ++i) {
    script.Add<std::uint64_t>(number, kBegin + 10 * i * kMs, i, i);
    script.Add<std::uint64_t>(other, kBegin + 10 * i * kMs, 100 + i, i);
    if (i == 4) script.Add<std::uint64_t>(reached, kBegin + 45 * kMs, 7);
    if (i % 2 == 1) script.Sync();
  }
  return script;
}

TEST(Playback, LeavesOutTheCallsOfCommands) {
  Script script;
  const auto reached = script.AddEvent("robot/arm/Control.Reached");
  const auto move_to = script.AddCommand("robot/arm/Control.MoveTo");
  script.Add<std::uint64_t>(reached, kBegin, 1);
  script.Add<std::uint64_t>(move_to, kBegin + 10 * kMs, 2);
  script.Add<std::uint64_t>(reached, kBegin + 20 * kMs, 3);
  const auto playback = script.Open();

  EXPECT_EQ(playback->FindNext(Playback::Kind::kEvents, kBegin), kBegin + 20 * kMs);
  EXPECT_THAT(playback->columns(), IsEmpty());
  EXPECT_THAT(Play(*playback, kBegin + 30 * kMs),
              ElementsAre("event Reached=1 at 0", "event Reached=3 at 20"));
}

TEST(Playback, PlaysWhatHappenedAfterThePositionUpToATime) {
  const auto playback = TenRows().Open();
  playback->Choose({"robot/arm/state.Number"});

  EXPECT_THAT(Play(*playback, kBegin + 10 * kMs), ElementsAre("Number=0 at 0", "Number=1 at 10"));
  EXPECT_THAT(Play(*playback, kBegin + 19 * kMs), IsEmpty());
  EXPECT_THAT(Play(*playback, kBegin + 50 * kMs),
              ElementsAre("Number=2 at 20", "Number=3 at 30", "Number=4 at 40",
                          "event Reached=7 at 45", "Number=5 at 50"));
  EXPECT_EQ(playback->position(), kBegin + 50 * kMs);
  EXPECT_THAT(Play(*playback, kBegin + 40 * kMs), IsEmpty()) << "time does not go back by playing";
}

TEST(Playback, GoesOnFromWhereItWasMovedTo) {
  const auto playback = TenRows().Open();
  playback->Choose({"robot/arm/state.Number"});
  Play(*playback, kBegin + 90 * kMs);

  playback->Seek(kBegin + 15 * kMs);

  EXPECT_THAT(Play(*playback, kBegin + 30 * kMs), ElementsAre("Number=2 at 20", "Number=3 at 30"));
}

TEST(Playback, HandsOutNoValuesOfColumnsThatAreNotChosen) {
  const auto playback = TenRows().Open();

  EXPECT_THAT(Play(*playback, kBegin + 90 * kMs), ElementsAre("event Reached=7 at 45"));
}

TEST(Playback, HandsOutThePastOfColumnsUpToThePosition) {
  const auto playback = TenRows().Open();
  playback->Seek(kBegin + 35 * kMs);

  EXPECT_THAT(PastOf(*playback, {"robot/arm/state.Other"}, kBegin + 20 * kMs),
              ElementsAre("Other=102 at 20", "Other=103 at 30"));
}

TEST(Playback, HandsOutTheLossesOfThePastOnlyIfTheyAreWanted) {
  Script script = TenRows();
  const auto lost = script.AddOwn(kLossTopic);
  script.Add(lost, kBegin + 92 * kMs, Loss{"robot/arm/state", 12, 0, 0});
  const auto playback = script.Open();
  playback->Seek(kBegin + 95 * kMs);

  const std::vector<std::string> columns{"robot/arm/state.Number"};
  EXPECT_THAT(PastOf(*playback, columns, kBegin + 90 * kMs), ElementsAre("Number=9 at 90"));
  EXPECT_THAT(PastOf(*playback, columns, kBegin + 90 * kMs, Playback::WithLosses::kYes),
              ElementsAre("Number=9 at 90", "lost 12 at 92"));
}

TEST(Playback, AColumnWithoutValuesInThePastHasItsNewestOne) {
  const auto playback = TenRows().Open();
  playback->Seek(kBegin + 38 * kMs);

  EXPECT_THAT(PastOf(*playback, {"robot/arm/state.Number"}, kBegin + 35 * kMs),
              ElementsAre("Number=3 at 30"));
  EXPECT_THAT(PastOf(*playback, {"robot/arm/state.Nothing"}, kBegin), IsEmpty());
}

TEST(Playback, FindsAnOldValueBehindManyChunksOfAnotherColumn) {
  Script script;
  const auto number = script.AddColumn("robot/arm/state.Number");
  const auto old = script.AddColumn("robot/arm/state.Old");
  script.Add<std::uint64_t>(old, kBegin, 7);
  script.Sync();
  for (std::uint32_t i = 1; i <= 100; ++i) {
    script.Add<std::uint64_t>(number, kBegin + i * kMs, i, i);
    script.Sync();
  }
  const auto playback = script.Open();
  playback->Seek(kBegin + 200 * kMs);

  EXPECT_THAT(
      PastOf(*playback, {"robot/arm/state.Number", "robot/arm/state.Old"}, kBegin + 150 * kMs),
      ElementsAre("Number=100 at 100", "Old=7 at 0"));
}

TEST(Playback, ReadsOnlyTheChunksOfTheTimeThatIsWanted) {
  Script script;
  const auto number = script.AddColumn("robot/arm/state.Number");
  for (std::uint32_t i = 0; i < 1000; ++i) {
    script.Add<std::uint64_t>(number, kBegin + i * kMs, i, i);
    script.Sync();
  }
  EXPECT_EQ(script.Open()->last_time(), kBegin + 999 * kMs);
  const auto reads = std::make_shared<test::MemoryFile::Reads>();
  auto reader = mcap::Reader::Open(std::make_unique<test::MemoryFile>(script.bytes(), reads));
  ASSERT_TRUE(reader);
  auto opened = Playback::Open(*std::move(reader));
  ASSERT_TRUE(opened);
  const std::unique_ptr<Playback> playback = *std::move(opened);
  const std::uint64_t before = reads->bytes;

  playback->Choose({"robot/arm/state.Number"});
  playback->Seek(kBegin + 500 * kMs);
  EXPECT_EQ(PastOf(*playback, {"robot/arm/state.Number"}, kBegin + 490 * kMs).size(), 11U);
  EXPECT_EQ(Play(*playback, kBegin + 510 * kMs).size(), 10U);

  EXPECT_LT(reads->bytes - before, script.bytes().size() / 4);
}

TEST(Playback, StepsToTheNextAndThePreviousRowOrEvent) {
  const auto playback = TenRows().Open();
  playback->Choose({"robot/arm/state.Number"});
  playback->Seek(kBegin + 40 * kMs);

  EXPECT_EQ(playback->NextStep(), kBegin + 45 * kMs);
  EXPECT_EQ(playback->PreviousStep(), kBegin + 30 * kMs);
  playback->Seek(kBegin);
  EXPECT_EQ(playback->PreviousStep(), std::nullopt);
  playback->Seek(kBegin + 90 * kMs);
  EXPECT_EQ(playback->NextStep(), std::nullopt);
}

TEST(Playback, FindsEventsAndLosses) {
  Script script = TenRows();
  const auto lost = script.AddOwn(kLossTopic);
  script.Add(lost, kBegin + 60 * kMs, Loss{"robot/arm/state", 12, 0, 0});
  const auto playback = script.Open();

  using Kind = Playback::Kind;
  EXPECT_EQ(playback->FindNext(Kind::kEvents, kBegin), kBegin + 45 * kMs);
  EXPECT_EQ(playback->FindNext(Kind::kEvents, kBegin + 45 * kMs), std::nullopt);
  EXPECT_EQ(playback->FindPrevious(Kind::kLosses, kBegin + 90 * kMs), kBegin + 60 * kMs);
  EXPECT_THAT(playback->Spans(Kind::kEvents),
              ElementsAre(PlayedSpan{kBegin + 45 * kMs, kBegin + 45 * kMs}));
  EXPECT_THAT(playback->Spans(Kind::kLosses),
              ElementsAre(PlayedSpan{kBegin + 60 * kMs, kBegin + 60 * kMs}));
}

TEST(Playback, ListsTheLastEventsAndLogRecordsBeforeThePosition) {
  Script script;
  const auto reached = script.AddEvent("robot/arm/Control.Reached");
  const auto log = script.AddOwn(kLogTopic);
  for (std::uint32_t i = 0; i < 6; ++i) {
    script.Add<std::uint64_t>(reached, kBegin + i * kMs, i);
    script.Add(log, kBegin + i * kMs, RosLog{.name = "robot/arm", .msg = std::to_string(i)});
    script.Sync();
  }
  const auto playback = script.Open();
  playback->Seek(kBegin + 4 * kMs);

  Listener events;
  playback->LastEvents(2, std::ref(events));
  Listener records;
  playback->LastLog(3, std::ref(records));

  EXPECT_THAT(events.all, ElementsAre("event Reached=3 at 3", "event Reached=4 at 4"));
  EXPECT_THAT(records.all, ElementsAre("log 2 at 2", "log 3 at 3", "log 4 at 4"));
}

CatalogueChange ProcessChange(std::uint64_t revision, const std::string& name,
                              ProcessState state = ProcessState::kAlive) {
  CatalogueChange change;
  change.revision = revision;
  change.process = name;
  change.processes.push_back(
      {.name = name, .host = {}, .address = {}, .state = state, .reason = {}});
  return change;
}

TEST(Playback, HasTheCatalogueAsOfThePosition) {
  Script script;
  const auto catalogue = script.AddOwn(kCatalogueTopic);
  script.Add(catalogue, kBegin + 10 * kMs, ProcessChange(41, "robot"), 0);
  script.Add(catalogue, kBegin + 10 * kMs, ProcessChange(42, "desk"), 1);
  script.Sync();
  script.Add(catalogue, kBegin + 20 * kMs, ProcessChange(43, "robot", ProcessState::kLost), 2);
  script.Add(catalogue, kBegin + 30 * kMs, ProcessChange(7, "robot"), 0);  // of another GCM
  const auto playback = script.Open();

  const auto state = [&] { return playback->CatalogueNow().FindProcess("robot")->process.state; };
  playback->Seek(kBegin);
  EXPECT_EQ(playback->CatalogueNow().processes().size(), 2U) << "before the first one: the first";
  playback->Seek(kBegin + 25 * kMs);
  EXPECT_EQ(state(), ProcessState::kLost);
  playback->Seek(kBegin + 30 * kMs);
  EXPECT_EQ(playback->CatalogueNow().processes().size(), 1U);
  playback->Seek(kBegin + 15 * kMs);
  EXPECT_EQ(state(), ProcessState::kAlive) << "it goes back, too";
}

TEST(Playback, AFileWithoutACatalogueHasOneOfItsColumns) {
  const auto playback = TenRows().Open();

  const Catalogue catalogue = playback->CatalogueNow();

  const ComponentDescription* arm = catalogue.FindComponent("robot", "arm");
  ASSERT_NE(arm, nullptr);
  ASSERT_EQ(arm->tables.size(), 1U);
  EXPECT_EQ(arm->tables[0].name, "state");
  ASSERT_EQ(arm->tables[0].columns.size(), 2U);
  EXPECT_EQ(arm->tables[0].columns[1].name, "Other");
}

TEST(Playback, ARestartOfTheSourceIsAnotherRun) {
  Script script;
  const auto first = script.AddColumn("robot/arm/state.Number", "1");
  const auto second = script.AddColumn("robot/arm/state.Number", "2");
  script.Add<std::uint64_t>(first, kBegin, 1, 900);
  script.Add<std::uint64_t>(second, kBegin + kMs, 2, 0);
  const auto playback = script.Open();
  playback->Choose({"robot/arm/state.Number"});

  std::vector<std::pair<std::uint64_t, std::uint64_t>> runs;
  playback->PlayUpTo(kBegin + kMs, [&](const PlayedItem& item) {
    const auto& value = std::get<PlayedValue>(item.content);
    runs.emplace_back(value.channel->run, value.tick);
  });

  EXPECT_THAT(runs, ElementsAre(std::pair(1U, 900U), std::pair(2U, 0U)));
  EXPECT_THAT(playback->columns(), ElementsAre("robot/arm/state.Number"));
}

TEST(Playback, AFileThatIsNotOfTendonIsRefusedWithWhatToDo) {
  const mcap::Sample sample(mcap::Compression::kNone);

  const auto playback = Playback::Open(mcap::Open(sample.bytes));

  ASSERT_FALSE(playback);
  EXPECT_THAT(playback.error().message, HasSubstr("no table, event or log that Tendon recorded"));
  EXPECT_THAT(playback.error().message, HasSubstr("gcm info"));
}

TEST(Playback, AFileWithoutMessagesIsRefused) {
  Script script;
  script.AddColumn("robot/arm/state.Number");
  script.Close();

  const auto playback = Playback::Open(mcap::Open(script.bytes()));

  ASSERT_FALSE(playback);
  EXPECT_THAT(playback.error().message, HasSubstr("contains no message"));
}

TEST(Playback, TimesThatDoNotFitInSignedNumbersAreRefusedWithTheTime) {
  constexpr auto kLast = static_cast<mcap::Timestamp>(std::numeric_limits<std::int64_t>::max());
  for (const mcap::Timestamp time : {kLast, kLast + 1, mcap::kLastTime - 1}) {
    Script script;
    const auto number = script.AddColumn("robot/arm/state.Number");
    script.Add<std::uint64_t>(number, kBegin, 1);
    script.Add<std::uint64_t>(number, time, 2);
    script.Close();

    const auto playback = Playback::Open(mcap::Open(script.bytes()));

    ASSERT_FALSE(playback);
    EXPECT_THAT(playback.error().message, HasSubstr(std::to_string(time)));
  }
}

TEST(Playback, AFileWithoutItsEndIsPlayedAsFarAsItGoes) {
  Script script = TenRows();
  (void)script.Open();
  mcap::Buffer cut = script.bytes();
  cut.resize(cut.size() * 6 / 10);

  auto playback = Playback::Open(mcap::Open(cut));

  ASSERT_TRUE(playback) << playback.error().message;
  EXPECT_TRUE((*playback)->reader().was_scanned());
  (*playback)->Choose({"robot/arm/state.Number"});
  EXPECT_FALSE(Play(**playback, mcap::kLastTime).empty());
}

}  // namespace
}  // namespace tendon::recording
