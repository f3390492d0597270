#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "core/interface/waiting_fixture.h"

namespace tendon_test {
namespace {

/// A numbered value that detects tearing.
struct Parcel {
  std::uint64_t number = 0;
  std::array<std::uint64_t, 5> copies{};
  std::uint64_t checksum = 0;
};

Parcel MakeParcel(std::uint64_t number) {
  Parcel parcel{.number = number, .copies = {}, .checksum = 0};
  parcel.copies.fill(number * 0x9e3779b97f4a7c15);
  parcel.checksum = number ^ parcel.copies[0];
  return parcel;
}

bool IsWhole(const Parcel& parcel) {
  const Parcel expected = MakeParcel(parcel.number);
  return parcel.copies == expected.copies && parcel.checksum == expected.checksum;
}

}  // namespace
}  // namespace tendon_test

template <>
inline constexpr auto tendon::kPayload<tendon_test::Parcel> =
    tendon::Describe("test.Parcel", tendon::Field{"number", &tendon_test::Parcel::number},
                     tendon::Field{"copies", &tendon_test::Parcel::copies},
                     tendon::Field{"checksum", &tendon_test::Parcel::checksum});

namespace tendon_test {
namespace {

using tendon::Connection;
using tendon::Status;

/// Receives parcels in the thread of its inbox. Their numbers must only increase.
struct Receiver {
  std::uint64_t received = 0;
  std::uint64_t sum = 0;
  std::uint64_t wrong = 0;
  std::uint64_t newest = 0;

  void Take(const Parcel& parcel) {
    if (!IsWhole(parcel) || parcel.number <= newest) ++wrong;
    newest = parcel.number;
    sum += parcel.number;
    ++received;
  }
};

struct Depot : Receiver {
  tendon::Inbox inbox;
  tendon::ProvidedInterface dock{"Dock", &inbox};
  tendon::WriteEvent<Parcel> sent;

  Depot() {
    dock.AddCommandWrite(&Depot::Take, this, "Take");
    dock.AddCommandWriteReturn(&Depot::Weigh, this, "Weigh");
    dock.AddEvent(sent, "Sent");
    inbox.SetAccepting(true);
  }
  void Weigh(const Parcel& parcel, std::uint64_t& weight) { weight = parcel.checksum; }
};

struct Carrier : Receiver {
  tendon::Inbox inbox;
  tendon::RequiredInterface depot{"Depot", &inbox};
  tendon::WriteFunction<Parcel> take;
  tendon::WriteReturnFunction<Parcel, std::uint64_t> weigh;

  Carrier() {
    depot.AddFunction(take, "Take");
    depot.AddFunction(weigh, "Weigh");
    depot.AddEventHandlerWrite(&Carrier::Take, this, "Sent");
    inbox.SetAccepting(true);
  }
};

/// Both ends run while they are repeatedly connected and disconnected.
TEST(ConnectionStress, AcceptedCallsSurviveReconnectsCompleteAndInOrder) {
  constexpr int kConnections = 150;
  Depot depot;
  Carrier carrier;
  std::atomic<bool> is_over = false;
  std::atomic<std::uint64_t> accepted = 0;
  std::uint64_t accepted_sum = 0;
  std::uint64_t wrong_answers = 0;
  std::jthread server([&] {
    depot.inbox.BindToThisThread();
    for (std::uint64_t number = 1; !is_over; ++number) {
      depot.inbox.ExecuteQueued();
      depot.sent(MakeParcel(number));
    }
    depot.inbox.ExecuteQueued();
  });
  std::jthread client([&] {
    carrier.inbox.BindToThisThread();
    for (std::uint64_t number = 1; !is_over; ++number) {
      if (carrier.take(MakeParcel(number)) == Status::kQueued) {
        accepted_sum += number;
        ++accepted;
      }
      const Parcel parcel = MakeParcel(number);
      std::uint64_t weight = 0;
      if (number % 16 == 0 && carrier.weigh.Wait(parcel, weight, 60s) == Status::kDone &&
          weight != parcel.checksum) {
        ++wrong_answers;
      }
      carrier.inbox.ExecuteQueued();
    }
    carrier.inbox.ExecuteQueued();
  });

  std::uint64_t dropped = 0;
  for (int round = 0; round < kConnections; ++round) {
    auto connection =
        std::move(*Connection::Make(carrier.depot, depot.dock, "carrier/Depot", "depot/Dock"));
    const std::uint64_t before = accepted;
    ASSERT_TRUE(EventuallyTrue([&] { return accepted > before; }));
    dropped += connection->Close(60s);
  }
  is_over = true;
  server.join();
  client.join();

  EXPECT_EQ(dropped, 0U);
  EXPECT_EQ(depot.wrong, 0U);
  EXPECT_EQ(depot.received, accepted);
  EXPECT_EQ(depot.sum, accepted_sum);
  EXPECT_EQ(wrong_answers, 0U);
  EXPECT_EQ(carrier.wrong, 0U);
  EXPECT_GT(carrier.received, 0U);
}

}  // namespace
}  // namespace tendon_test
