#include <tendon/manager/component_registry.h>
#include <tests/system/faults/instruments/client.h>
#include <tests/system/faults/instruments/drive.h>
#include <tests/system/faults/instruments/edited.h>
#include <tests/system/faults/instruments/fountain.h>
#include <tests/system/faults/instruments/herald.h>
#include <tests/system/faults/instruments/jogger.h>
#include <tests/system/faults/instruments/ledger.h>
#include <tests/system/faults/instruments/loggers.h>
#include <tests/system/faults/instruments/parcels.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  using namespace faults;  // NOLINT(google-build-using-namespace): every class is from there
  registry.Add<Client>("Client");
  registry.Add<Ledger>("Ledger");
  registry.Add<Drive>("Drive");
  registry.Add<Driver>("Driver");
  registry.Add<Fountain>("Fountain");
  registry.Add<Herald>("Herald");
  registry.Add<Jogger>("Jogger");
  registry.Add<Raver>("Raver");
  registry.Add<Calm>("Calm");
  registry.Add<Sender>("Sender");
  registry.Add<Receiver>("Receiver");
  registry.Add<Sensor>("Sensor");
  registry.Add<Pusher<Force>>("Pusher");
  registry.Add<Pusher<ForceInFloats>>("PusherInFloats");
  registry.Add<Pusher<ForceInPounds>>("PusherInPounds");
  registry.Add<Pusher<ForceRenamed>>("PusherRenamed");
  registry.Add<Pusher<ForceWithMore>>("PusherWithMore");
  registry.Add<Pusher<ForceWithLess>>("PusherWithLess");
  registry.Add<Pusher<ForceInOtherOrder>>("PusherInOtherOrder");
  registry.Add<Pusher<ForceOfOtherShape>>("PusherOfOtherShape");
  registry.Add<Pusher<ForceInOtherFrames>>("PusherInOtherFrames");
}
