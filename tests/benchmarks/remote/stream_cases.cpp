#include <benchmarks/remote/remote_system.h>
#include <tendon/process/telemetry/make_telemetry_client.h>

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace tendon::benchmark {
namespace {

/// The size of a row on the wire: 7 doubles, tick and time.
constexpr std::size_t kRowBytes = sizeof(Argument) + 2 * sizeof(std::uint64_t);
constexpr std::uint64_t kRowsInAMessage = 100;

/// Counts rows, and measures the time of their arrival.
class Counter final : public RowSink {
 public:
  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {
    const std::scoped_lock lock(mutex_);
    stands_ = true;
    changed_.notify_one();
  }
  void OnRows(const RowBatch& batch) override {
    if (batch.count == 0) return;
    for (std::size_t row = 0; row < batch.count; ++row) {
      const auto cell = batch.cell(row, 0);
      Use(cell);
    }
    const std::scoped_lock lock(mutex_);
    last_ = std::chrono::steady_clock::now();
    if (rows_ == 0) {
      first_ = last_;
      in_first_ = batch.count;
    }
    rows_ += batch.count;
    lost_ += batch.lost.all();
    changed_.notify_one();
  }
  void OnStale(const Error& /*reason*/) override {}

  bool AwaitSubscription() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kTestTimeout, [this] { return stands_; });
  }
  void Forget() {
    const std::scoped_lock lock(mutex_);
    rows_ = lost_ = 0;
  }
  /// Returns the time per row. The measurement begins when the first batch arrives.
  double Await(std::uint64_t rows) {
    std::unique_lock lock(mutex_);
    Require(changed_.wait_for(lock, kTestTimeout, [&] { return rows_ + lost_ >= rows; }) &&
                rows_ > in_first_,
            "the rows do not come");
    const std::chrono::duration<double, std::nano> took = last_ - first_;
    return took.count() / static_cast<double>(rows_ - in_first_);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stands_ = false;
  std::uint64_t rows_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t in_first_ = 0;
  std::chrono::steady_clock::time_point first_;
  std::chrono::steady_clock::time_point last_;
};

/// One subscription to the robot's table.
class Stream {
 public:
  explicit Stream(RemoteSystem& system)
      : client_(MakeTelemetryClient(
            system.Options().middleware,
            [address = system.addresses().robot](const std::string&) -> Result<std::string> {
              return address;
            },
            NewHello("viewer"))) {
    client_->Subscribe(
        {.process = "robot", .component = "robot", .table = "state-History", .columns = {"Joints"}},
        counter_);
    Require(counter_->AwaitSubscription(), "the robot's table cannot be watched");
  }

  double Run(RemoteSystem& system, std::uint64_t rows) {
    counter_->Forget();
    Require(static_cast<bool>(system.desk().record.Wait(rows, kTestTimeout)),
            "nothing is recorded");
    return counter_->Await(rows);
  }

 private:
  const std::shared_ptr<Counter> counter_ = std::make_shared<Counter>();
  const std::unique_ptr<TelemetryClient> client_;
};

double SendRaw(RemoteSystem& system, std::uint64_t rows) {
  const std::vector<std::byte> message(kRowsInAMessage * kRowBytes);
  const std::uint64_t messages = std::max<std::uint64_t>(rows / kRowsInAMessage, 1);
  return NanosecondsEach(1, [&](std::uint64_t) { system.raw().Write(message, messages); }) /
         static_cast<double>(messages * kRowsInAMessage);
}

}  // namespace

std::vector<Case> StreamCases(const Effort& effort, const TheSystem& system) {
  constexpr double kMax = 1e9 / 5e6;                            // ns per row
  const std::uint64_t rows = effort.is_tiny ? 10'000 : 60'000;  // more rows than one batch holds
  const auto stream = std::make_shared<std::unique_ptr<Stream>>();
  const auto run = [=](RemoteSystem& both) {
    if (!*stream) *stream = std::make_unique<Stream>(both);
    return (*stream)->Run(both, rows);
  };
  const auto both_ends = [&](auto function) {
    Subject subject = Between(system, function);
    subject.processors = kSleeps;  // the subject sleeps until the next batch is due
    return subject;
  };
  const auto side_by_side = SideBySide(
      both_ends(run), Between(system, [=](RemoteSystem& both) { return SendRaw(both, rows); }));
  return {
      {.id = "R6",
       .what = "rows streamed, 7 doubles and time / raw Ice oneway",
       .ratio = Ratio::kOfThroughputs,
       .gate = 0.5,
       .stretch = 0.85,
       .repetition = side_by_side},
      {.id = "R6-row",
       .what = "the same, what a row takes",
       .gate = kMax,
       .repetition = [=]() -> std::optional<Pair> {
         const auto pair = side_by_side();
         return pair ? std::optional(Pair{.ours = pair->ours}) : std::nullopt;
       }},
  };
}

}  // namespace tendon::benchmark
