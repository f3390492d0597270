#include <gtest/gtest.h>
#include <tendon/gcm/catalogue.h>
#include <tests/core/gcm/samples.h>

#include <random>

namespace tendon {
namespace {

using Kind = CatalogueChange::Kind;

/// Makes random changes that are valid for the present catalogue.
class RandomChanges {
 public:
  explicit RandomChanges(std::uint32_t seed) : random_(seed) {}

  CatalogueChange Next(const Catalogue& catalogue) {
    CatalogueChange change = Draw(catalogue);
    change.revision = catalogue.revision() + 1;
    return change;
  }

 private:
  std::uint64_t Below(std::uint64_t limit) { return random_() % limit; }
  std::string Name(const std::string& stem) { return stem + std::to_string(Below(4)); }

  CatalogueChange ProcessChange() {
    auto process = test::ProcessNamed(Name("process"), Below(2));
    process.state = static_cast<ProcessState>(Below(4));
    return {.kind = Kind::kProcess, .process = process.name, .processes = {process}};
  }

  CatalogueChange Draw(const Catalogue& catalogue) {
    if (catalogue.processes().empty()) return ProcessChange();
    auto chosen = catalogue.processes().begin();
    std::advance(chosen, Below(catalogue.processes().size()));
    const auto& [name, entry] = *chosen;
    switch (Below(8)) {
      case 0:
        return ProcessChange();
      case 1:
        if (Below(4) == 0) return {.kind = Kind::kProcessRemoved, .process = name};
        break;
      case 2:
        if (entry.components.empty()) break;
        return {.kind = Kind::kComponentRemoved,
                .process = name,
                .component = entry.components.begin()->first};
      case 3:
        if (entry.connections.empty()) break;
        return {.kind = Kind::kConnectionRemoved,
                .process = name,
                .connection = entry.connections.begin()->first};
      case 4:
      case 5: {
        ConnectionDescription connection{.id = Below(5),
                                         .required = {name, Name("component"), "Robot"},
                                         .provided = {Name("process"), "arm", "Control"},
                                         .state = static_cast<ConnectionState>(Below(3))};
        return {.kind = Kind::kConnection, .process = name, .connections = {connection}};
      }
      default:
        break;
    }
    return {.kind = Kind::kComponent,
            .process = name,
            .components = {Below(2) == 0 ? test::Arm(Name("component"))
                                         : test::Teleoperation(Name("component"))}};
  }

  std::mt19937 random_;
};

Catalogue RandomCatalog(std::uint32_t seed) {
  Catalogue catalogue;
  RandomChanges changes(seed);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(catalogue.Apply(changes.Next(catalogue)));
  return catalogue;
}

TEST(Catalogue, ACopyFedByTheChangesEqualsTheOriginal) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    RandomChanges changes(seed);
    Catalogue original;
    Catalogue copy;
    for (int i = 0; i < 200; ++i) {
      const CatalogueChange change = changes.Next(original);
      ASSERT_TRUE(original.Apply(change));
      ASSERT_TRUE(copy.Apply(change));
      ASSERT_EQ(original, copy) << "seed " << seed << ", change " << i;
    }
    EXPECT_EQ(original.ContentHash(), copy.ContentHash());
  }
}

TEST(Catalogue, ASnapshotAsChangesBuildsTheSameCatalogue) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Catalogue original = RandomCatalog(seed);

    const auto changes = original.AsChanges();
    Catalogue built = Catalogue::At(original.revision() - changes.size());
    for (const CatalogueChange& change : changes) ASSERT_TRUE(built.Apply(change));

    EXPECT_EQ(original, built) << "seed " << seed;
  }
}

TEST(Catalogue, RefusesAChangeWithAnUnexpectedRevision) {
  Catalogue catalogue = RandomCatalog(1);
  const Catalogue before = catalogue;
  RandomChanges changes(2);
  for (const int distance : {-1, 0, 2, 100}) {
    CatalogueChange change = changes.Next(catalogue);
    change.revision = catalogue.revision() + static_cast<std::uint64_t>(distance);

    EXPECT_FALSE(catalogue.Apply(change));
    EXPECT_EQ(catalogue, before);
  }
}

TEST(Catalogue, RefusesAnInvalidChange) {
  Catalogue catalogue;
  const Catalogue before = catalogue;
  const std::vector<CatalogueChange> changes = {
      {.revision = 1, .kind = Kind::kProcess, .process = "robot"},
      {.revision = 1,
       .kind = Kind::kProcess,
       .process = "robot",
       .processes = {test::ProcessNamed("desk", 1)}},
      {.revision = 1, .kind = Kind::kProcessRemoved, .process = "robot"},
      {.revision = 1, .kind = Kind::kComponent, .process = "robot", .components = {test::Arm()}}};
  for (const CatalogueChange& change : changes) {
    EXPECT_FALSE(catalogue.Apply(change));
    EXPECT_EQ(catalogue, before);
  }
}

TEST(Catalogue, ANewProcessInstanceStartsEmpty) {
  Catalogue catalogue;
  const auto apply = [&](CatalogueChange change) {
    change.revision = catalogue.revision() + 1;
    ASSERT_TRUE(catalogue.Apply(change));
  };
  apply(
      {.kind = Kind::kProcess, .process = "robot", .processes = {test::ProcessNamed("robot", 1)}});
  apply({.kind = Kind::kComponent, .process = "robot", .components = {test::Arm()}});
  apply(
      {.kind = Kind::kProcess, .process = "robot", .processes = {test::ProcessNamed("robot", 1)}});
  ASSERT_NE(catalogue.FindComponent("robot", "arm"), nullptr);

  apply(
      {.kind = Kind::kProcess, .process = "robot", .processes = {test::ProcessNamed("robot", 2)}});

  EXPECT_EQ(catalogue.FindComponent("robot", "arm"), nullptr);
}

/// Returns a catalogue of a process with an arm and a connection. All numbers are shifted by
/// `offset`.
Catalogue System(std::uint64_t offset) {
  Catalogue catalogue = Catalogue::At(offset);
  auto process = test::ProcessNamed("desk", offset);
  process.since = static_cast<std::int64_t>(offset);
  process.reason = std::string(offset, 'x');
  const ConnectionDescription connection{.id = offset,
                                         .required = {"desk", "teleoperation", "Robot"},
                                         .provided = {"robot", "arm", "Control"},
                                         .reason = std::string(offset, 'y')};
  EXPECT_TRUE(catalogue.Apply(
      {.revision = offset + 1, .kind = Kind::kProcess, .process = "desk", .processes = {process}}));
  EXPECT_TRUE(catalogue.Apply({.revision = offset + 2,
                               .kind = Kind::kComponent,
                               .process = "desk",
                               .components = {test::Teleoperation()}}));
  EXPECT_TRUE(catalogue.Apply({.revision = offset + 3,
                               .kind = Kind::kConnection,
                               .process = "desk",
                               .connections = {connection}}));
  return catalogue;
}

TEST(Catalogue, TheContentHashIgnoresPerRunValues) {
  EXPECT_NE(System(1), System(7));
  EXPECT_EQ(System(1).ContentHash(), System(7).ContentHash());
}

TEST(Catalogue, TheContentHashSeesEachKindOfContent) {
  const Catalogue catalogue = System(1);
  const auto changed = [&](CatalogueChange change) {
    Catalogue other = catalogue;
    change.revision = other.revision() + 1;
    change.process = "desk";
    EXPECT_TRUE(other.Apply(change));
    return other.ContentHash();
  };
  auto process = catalogue.FindProcess("desk")->process;
  process.state = ProcessState::kSuspect;
  auto component = test::Teleoperation();
  component.state = ComponentState::kFaulted;
  auto follower = test::Teleoperation();
  follower.leader = "arm";
  auto threaded = test::Teleoperation();
  threaded.thread = {ThreadOptions()};
  auto connection = catalogue.connections().front();
  connection.state = ConnectionState::kFailed;

  const Fingerprint before = catalogue.ContentHash();
  EXPECT_NE(changed({.kind = Kind::kProcess, .processes = {process}}), before);
  for (const ComponentDescription& one : {component, follower, threaded}) {
    EXPECT_NE(changed({.kind = Kind::kComponent, .components = {one}}), before);
  }
  EXPECT_NE(changed({.kind = Kind::kConnection, .connections = {connection}}), before);
  EXPECT_NE(changed({.kind = Kind::kConnectionRemoved, .connection = connection.id}), before);
  EXPECT_NE(changed({.kind = Kind::kProcessRemoved}), before);
}

TEST(Catalogue, FindsOnlyExistingEntries) {
  const Catalogue catalogue = System(1);
  const InterfaceName robot("desk", "teleoperation", "Robot");

  EXPECT_NE(catalogue.FindRequired(robot), nullptr);
  EXPECT_EQ(catalogue.FindProvided(robot), nullptr);
  ASSERT_NE(catalogue.FindConnection(robot), nullptr);
  EXPECT_EQ(catalogue.FindConnection(robot)->provided, InterfaceName("robot", "arm", "Control"));
  EXPECT_EQ(catalogue.FindConnection({"desk", "teleoperation", "Other"}), nullptr);
  EXPECT_EQ(catalogue.FindProcess("robot"), nullptr);
  EXPECT_EQ(catalogue.FindComponent("robot", "arm"), nullptr);
  EXPECT_EQ(catalogue.connections().size(), 1U);
}

}  // namespace
}  // namespace tendon
