#include <program/network_options.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/certificate_authority.h>

#include <atomic>
#include <csignal>
#include <cstddef>
#include <filesystem>

#include "support/log/log_record.h"
#include "system/faults/harness/broker.h"

namespace faults {
namespace {

using tendon::Broadcast;
using tendon::CertificateAuthority;
using tendon::Role;
using tendon::Status;

/// The broker, the GCM, the process and the viewers have certificates of one CA.
class CertifiedBroker : public BrokerTest {
 protected:
  CertifiedBroker() {
    more_environment_ = {{"TENDON_CA", authority_->folder()},
                         {"TENDON_CERTIFICATE", CertificateOf("anna", Role::kViewer)}};
  }

  /// Returns the file of the certificate of this process; issues the certificate if it does not
  /// exist.
  [[nodiscard]] std::string CertificateOf(const std::string& name, Role role) const {
    const auto folder = home_.path() / "issued";
    const auto file = folder / (name + ".crt");
    if (std::filesystem::exists(file)) return file;
    const auto issued =
        authority_->Issue({.name = name, .role = role, .holder = tendon::Holder::kProcess}, folder);
    EXPECT_TRUE(issued.ok()) << (issued.ok() ? "" : issued.error().message);
    return file;
  }
  [[nodiscard]] Words As(const std::string& name, Words words) const override {
    const Role role = name == "broker" ? Role::kViewer : Role::kOperator;
    words.insert(words.end(), {"--certificate", CertificateOf(name, role)});
    return words;
  }
  [[nodiscard]] std::shared_ptr<tendon::Middleware> NewMiddleware() const override {
    return MiddlewareOf("anna", Role::kViewer);
  }
  [[nodiscard]] std::shared_ptr<tendon::Middleware> MiddlewareOf(const std::string& name,
                                                                 Role role) const {
    auto made = program::MakeMiddleware({.middleware = GetParam(),
                                         .certificate = CertificateOf(name, role),
                                         .authority = authority_->folder()});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
    return made.ok() ? *std::move(made) : nullptr;
  }

 private:
  const tendon::Result<CertificateAuthority> authority_ =
      CertificateAuthority::Init(home_.path() / "ca");
};

INSTANTIATE_TEST_SUITE_P(Over, CertifiedBroker, testing::Values("ice"), NameOfMiddleware);

TEST_P(CertifiedBroker, AStoppedSubscriberHarmsNoOther) {
  constexpr std::uint64_t kFew = 100;
  std::vector<std::shared_ptr<StreamChecker>> streams;
  for (int i = 0; i < 15; ++i) {
    ASSERT_NO_FATAL_FAILURE(Watch(streams.emplace_back(std::make_shared<StreamChecker>())));
  }
  const auto stopped = std::make_shared<GatedReader>();
  ASSERT_NO_FATAL_FAILURE(Watch(stopped));
  ASSERT_TRUE(AllGetMore(streams, kFew)) << robot_->err();
  ASSERT_TRUE(Eventually([&] { return stopped->verdict().received >= kFew; }));

  auto gate = stopped->HoldGate();
  const std::uint64_t before_it_stopped = stopped->verdict().received;
  ASSERT_TRUE(AllGetMore(streams, kFew)) << "while the one takes nothing";
  gate.unlock();

  EXPECT_TRUE(Eventually([&] { return stopped->verdict().received > before_it_stopped + kFew; }));
  const StreamChecker::Verdict missed = stopped->verdict();
  Tell("stopped: " + ToString(missed) + "; another: " + ToString(streams.front()->verdict()));
  EXPECT_EQ(missed.missing, missed.counted);
  EXPECT_EQ(missed.repeated, 0U);
  EXPECT_EQ(missed.damaged, 0U);
  const std::uint64_t stale = streams.front()->verdict().stale.size();
  broker_->Signal(SIGKILL);
  EXPECT_TRUE(Eventually([&] { return streams.front()->verdict().stale.size() > stale; }))
      << "it was of no use";
}

/// A viewer may subscribe to topics and may create topics, but the broker drops its messages.
TEST_P(CertifiedBroker, ABrokerDropsMessagesPublishedByAViewer) {
  const std::string topic = "lamps";
  const tendon_test::LogRecord log("broker");
  std::atomic<int> of_viewer = 0;
  std::atomic<int> of_operator = 0;
  const auto listener = MiddlewareOf("eye", Role::kViewer);
  const auto viewer = MiddlewareOf("mallory", Role::kViewer);
  const auto boss = MiddlewareOf("boss", Role::kOperator);
  const auto by_viewer = viewer->broadcast()->OpenTopic(broker_address_, topic);
  const auto reception = listener->broadcast()->Subscribe(
      broker_address_, topic,
      [&](std::span<const std::byte> message) {
        of_viewer += static_cast<int>(message.front() == std::byte{1});
        of_operator += static_cast<int>(message.front() == std::byte{2});
      },
      Timeout());
  ASSERT_TRUE(reception.ok()) << reception.error().message;
  ASSERT_TRUE(Eventually([&] { return !log.texts().empty(); })) << "nobody says that it is refused";

  EXPECT_EQ(by_viewer->Publish(std::vector{std::byte{1}}), Status(Status::kNotConnected));
  const auto by_operator = boss->broadcast()->OpenTopic(broker_address_, topic);
  EXPECT_TRUE(Eventually([&] {
    (void)by_viewer->Publish(std::vector{std::byte{1}});
    (void)by_operator->Publish(std::vector{std::byte{2}});
    return of_operator > 0;
  }));
  EXPECT_EQ(of_viewer, 0);
}

}  // namespace
}  // namespace faults
