#include <benchmarks/remote/rivals/rival.h>
#include <dds/dds.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>

namespace tendon::benchmark {
namespace {

/// Uses only the loopback interface of this machine.
constexpr const char* kSettings = R"(<CycloneDDS><Domain><General>
<Interfaces><NetworkInterface name="lo"/></Interfaces><AllowMulticast>false</AllowMulticast>
</General><Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer address="127.0.0.1"/>
</Peers></Discovery></Domain></CycloneDDS>)";
/// A domain that other programs rarely use.
constexpr dds_domainid_t kDomain = 117;

struct Sample {
  std::uint64_t number = 0;
  std::uint8_t bytes[sizeof(Message)] = {};  // C requires an array
};

/// Returns an instruction as the IDL compiler of Cyclone DDS would generate it.
constexpr std::uint32_t Word(std::uint32_t code, std::uint32_t type, std::uint32_t of = 0) {
  return code | type | of;
}

constexpr std::uint32_t kFields[] = {Word(DDS_OP_ADR, DDS_OP_TYPE_8BY),
                                     offsetof(Sample, number),
                                     Word(DDS_OP_ADR, DDS_OP_TYPE_ARR, DDS_OP_SUBTYPE_1BY),
                                     offsetof(Sample, bytes),
                                     sizeof(Message),
                                     DDS_OP_RTS};

dds_topic_descriptor_t TypeOfSample() {
  return {.m_size = sizeof(Sample),
          .m_align = alignof(Sample),
          .m_flagset = DDS_TOPIC_FIXED_SIZE,
          .m_nkeys = 0,
          .m_typename = "tendon::Sample",
          .m_keys = nullptr,
          .m_nops = std::size(kFields),
          .m_ops = kFields,
          .m_meta = ""};
}

dds_entity_t Require(dds_entity_t entity) {
  if (entity < 0) throw std::runtime_error(std::string("CycloneDDS: ") + dds_strretcode(entity));
  return entity;
}

/// Both ends have a reliable writer and a reliable reader of the newest sample.
class End {
 public:
  End(const char* out, const char* in, dds_listener_t* listener)
      : domain_(Require(dds_create_domain(kDomain, kSettings))),
        participant_(Require(dds_create_participant(kDomain, nullptr, nullptr))) {
    dds_qos_t* rules = dds_create_qos();
    dds_qset_reliability(rules, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
    dds_qset_history(rules, DDS_HISTORY_KEEP_LAST, 1);
    writer_ = dds_create_writer(participant_, Topic(out), rules, nullptr);
    if (listener != nullptr) dds_lset_data_available_arg(listener, OnData, this, false);
    reader_ = dds_create_reader(participant_, Topic(in), rules, listener);
    dds_delete_qos(rules);
    Require(writer_);
    Require(reader_);
  }
  End(const End&) = delete;
  End& operator=(const End&) = delete;
  ~End() { dds_delete(domain_); }

  void Write(const Sample& sample) const { Require(dds_write(writer_, &sample)); }
  /// Takes the newest sample. Returns false if there is no new sample.
  bool Take(Sample& sample) const {
    void* place = &sample;
    dds_sample_info_t info;
    return dds_take(reader_, &place, &info, 1, 1) == 1 && info.valid_data;
  }
  [[nodiscard]] dds_entity_t reader() const { return reader_; }
  [[nodiscard]] dds_entity_t participant() const { return participant_; }

 private:
  /// Answers in the thread that has received the request.
  static void OnData(dds_entity_t /*reader*/, void* end) {
    const auto& self = *static_cast<const End*>(end);
    Sample sample;
    while (self.Take(sample)) (void)dds_write(self.writer_, &sample);
  }
  [[nodiscard]] dds_entity_t Topic(const char* name) const {
    const dds_topic_descriptor_t type = TypeOfSample();
    return Require(dds_create_topic(participant_, &type, name, nullptr, nullptr));
  }

  const dds_entity_t domain_;
  const dds_entity_t participant_;
  dds_entity_t writer_ = 0;
  dds_entity_t reader_ = 0;
};

class Server final : public RivalServer {
 public:
  [[nodiscard]] std::string address() const override { return "dds"; }

 private:
  using Listener = std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)>;
  const Listener listener_{dds_create_listener(nullptr), &dds_delete_listener};
  const End end_{"tendon_answers", "tendon_questions", listener_.get()};
};

class Client final : public RivalClient {
 public:
  Client() {
    const dds_entity_t condition = Require(dds_create_readcondition(end_.reader(), DDS_ANY_STATE));
    Require(dds_waitset_attach(arrivals_, condition, 0));
    constexpr int kTries = 200;  // until the two ends have discovered each other
    for (int i = 0; i < kTries; ++i) {
      if (Ask(DDS_MSECS(50))) return;
    }
    throw std::runtime_error("CycloneDDS: nobody answers");
  }

  void Read(Message& /*reply*/) override {
    if (!Ask(DDS_SECS(10))) throw std::runtime_error("CycloneDDS: no reply in time");
  }

 private:
  bool Ask(dds_duration_t timeout) {
    const Sample question{.number = ++last_};
    end_.Write(question);
    Sample reply;
    while (dds_waitset_wait(arrivals_, nullptr, 0, timeout) > 0) {
      if (end_.Take(reply) && reply.number == question.number) return true;
    }
    return false;
  }

  const End end_{"tendon_questions", "tendon_answers", nullptr};
  const dds_entity_t arrivals_ = Require(dds_create_waitset(end_.participant()));
  std::uint64_t last_ = 0;
};

}  // namespace

Rival CycloneDds() {
  return {.id = "R8-dds",
          .name = "CycloneDDS",
          .stretch = 1.05,
          .missing = {},
          .serve = [] { return std::make_unique<Server>(); },
          .reach = [](const std::string& /*address*/) { return std::make_unique<Client>(); }};
}

}  // namespace tendon::benchmark
