#include <gcm_console/output/dot.h>
#include <gcm_console/output/svg.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tests/core/gcm/samples.h>

#include <algorithm>
#include <csignal>
#include <regex>
#include <sstream>

#include "gcm_console/demo_fixture.h"
#include "support/locales.h"

namespace {

using console::Diagram;
using console::DiagramNode;
using console::DiagramOf;
using tendon::ComponentDescription;
using tendon::ConnectionState;
using tendon::graph::Rect;
using testing::HasSubstr;

bool IsWithin(const Rect& inner, const Rect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y &&
         inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

bool DoOverlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// A chain of processes with three components each. Each component uses the previous one.
class Chain {
 public:
  explicit Chain(int processes) {
    for (int i = 0; i < processes; ++i) Add("process_" + std::to_string(i));
  }
  [[nodiscard]] const tendon::Catalogue& catalogue() const { return catalogue_; }

 private:
  void Add(const std::string& process) {
    using Kind = tendon::CatalogueChange::Kind;
    Apply({.kind = Kind::kProcess,
           .process = process,
           .processes = {tendon::test::ProcessNamed(process, 1)}});
    for (int i = 0; i < 3; ++i) {
      ComponentDescription component{.name = Name(i), .class_name = "Worker<&>"};
      component.state = i == 1 ? tendon::ComponentState::kFaulted : tendon::ComponentState::kActive;
      component.provided = {{.name = "Output"}, {.name = "state"}};
      component.required = {{.name = "Input"}};
      Apply({.kind = Kind::kComponent, .process = process, .components = {component}});
    }
    for (int i = 1; i < 3; ++i) {
      const bool is_bad = i == 1;
      Apply({.kind = Kind::kConnection,
             .process = process,
             .connections = {{.id = static_cast<std::uint64_t>(i),
                              .required = {process, Name(i), "Input"},
                              .provided = {process, Name(i - 1), "Output"},
                              .state = is_bad ? ConnectionState::kFailed : ConnectionState::kActive,
                              .reason = is_bad ? "it is \"<broken>\"" : ""}}});
    }
  }
  static std::string Name(int i) { return "component_with_a_long_name_" + std::to_string(i); }
  void Apply(tendon::CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    EXPECT_TRUE(catalogue_.Apply(change));
  }

  tendon::Catalogue catalogue_;
};

/// Returns true if the tags of the text are balanced, as in XML.
bool IsBalanced(const std::string& text) {
  static const std::regex kTag("<(/?)([a-z]+)[^<>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator tag(text.begin(), text.end(), kTag), end; tag != end; ++tag) {
    if ((*tag)[3].length() > 0) continue;
    if ((*tag)[1].length() == 0) {
      open.push_back((*tag)[2]);
    } else if (open.empty() || open.back() != (*tag)[2]) {
      return false;
    } else {
      open.pop_back();
    }
  }
  const auto begins = std::count(text.begin(), text.end(), '<');
  return open.empty() && begins == std::count(text.begin(), text.end(), '>');
}

/// Expects that no text is cut off or overlaps another one.
void ExpectRoomForAll(const Diagram& diagram) {
  const Rect all{0, 0, diagram.size.width, diagram.size.height};
  for (const auto& process : diagram.processes) {
    EXPECT_TRUE(IsWithin(process.rect, all)) << process.name;
    for (const auto& other : diagram.processes) {
      EXPECT_TRUE(&other == &process || !DoOverlap(process.rect, other.rect)) << process.name;
    }
  }
  for (const DiagramNode& node : diagram.nodes) {
    const auto owner = std::ranges::find_if(diagram.processes, [&](const auto& process) {
      return node.path.starts_with(process.name + "/");
    });
    ASSERT_NE(owner, diagram.processes.end());
    EXPECT_TRUE(IsWithin(node.rect, owner->rect)) << node.path;
    EXPECT_GE(node.rect.width, console::TextWidth(node.name, 14)) << node.path;
    for (const DiagramNode& other : diagram.nodes) {
      EXPECT_TRUE(&other == &node || !DoOverlap(node.rect, other.rect)) << node.path;
    }
  }
}

TEST(DiagramOf, NodesDoNotOverlapAndFitInside) {
  const Diagram diagram = DiagramOf(Chain(4).catalogue());

  ASSERT_EQ(diagram.processes.size(), 4U);
  ASSERT_EQ(diagram.nodes.size(), 12U);
  ExpectRoomForAll(diagram);
}

/// Returns positions in one vertical line, in a small unit of length.
console::Places InALine(const Diagram& diagram) {
  console::Places places;
  double y = -50;
  for (const auto& process : diagram.processes) {
    const double top = y;
    y += 4;
    for (const DiagramNode& node : diagram.nodes) {
      if (!node.path.starts_with(process.name + "/")) continue;
      places[node.path] = {-7, y, 20, 10};
      y += 12;
    }
    places[process.name] = {-9, top, 24, y - top};
    y += 3;
  }
  return places;
}

TEST(DiagramOf, KeepsTheGivenArrangement) {
  const Chain chain(3);
  const console::Places shown = InALine(DiagramOf(chain.catalogue()));

  const Diagram diagram = DiagramOf(chain.catalogue(), shown);

  ExpectRoomForAll(diagram);
  EXPECT_EQ(diagram.wires.size(), 6U);
  for (const DiagramNode& node : diagram.nodes) {
    EXPECT_EQ(node.rect.x, diagram.nodes.front().rect.x) << node.path;
    EXPECT_EQ(node.rect.width, diagram.nodes.front().rect.width) << node.path;
    for (const DiagramNode& other : diagram.nodes) {
      EXPECT_EQ(node.rect.y < other.rect.y, shown.at(node.path).y < shown.at(other.path).y);
    }
  }
}

TEST(DiagramOf, FramesTighterThanNeededKeepTheDiagramSmall) {
  const Chain chain(2);
  console::Places shown = InALine(DiagramOf(chain.catalogue()));
  const Diagram usual = DiagramOf(chain.catalogue(), shown);
  for (auto& [name, rect] : shown) {
    const bool is_node = name.find('/') != std::string::npos;
    if (!is_node) rect = {rect.x + 1.9, rect.y + 3.9, rect.width - 3.8, rect.height - 5.8};
  }

  const Diagram diagram = DiagramOf(chain.catalogue(), shown);

  ExpectRoomForAll(diagram);
  EXPECT_LE(diagram.size.width, 5 * usual.size.width);
  EXPECT_LE(diagram.size.height, 5 * usual.size.height);
}

TEST(DiagramOf, FallsBackToColumnsIfAPlaceIsMissing) {
  const Chain chain(2);
  const Diagram columns = DiagramOf(chain.catalogue());
  console::Places shown = InALine(columns);
  shown.erase(shown.begin());

  const Diagram diagram = DiagramOf(chain.catalogue(), shown);

  EXPECT_EQ(diagram.nodes.back().rect, columns.nodes.back().rect);
}

TEST(PrintDot, WritesPositionsAlikeInAllLocales) {
  const Chain chain(1);
  Diagram diagram;
  diagram.size = {400, 300.5};
  diagram.processes = {{.name = "process_0", .rect = {24, 64, 200.25, 100}}};
  diagram.nodes = {
      {.path = "process_0/component_with_a_long_name_0", .rect = {44.5, 104, 108, 36}}};
  std::ostringstream out;

  {
    tendon::test::Locales german;
    ASSERT_TRUE(german.Use("de_DE"));
    console::PrintDot(chain.catalogue(), diagram, out);
  }

  EXPECT_THAT(out.str(), HasSubstr("layout=nop;"));
  EXPECT_THAT(out.str(), HasSubstr("    bb=\"24.000000,136.500000,224.250000,236.500000\";"));
  EXPECT_THAT(out.str(), HasSubstr(", fixedsize=true, width=1.500000, height=0.500000, "
                                   "pos=\"98.500000,178.500000\"]"));
}

TEST(PrintDot, WritesNoPositionsWithoutAnArrangement) {
  const Chain chain(2);
  std::ostringstream plain;
  console::PrintDot(chain.catalogue(), plain);
  EXPECT_THAT(plain.str(), testing::Not(HasSubstr("pos=")));
}

TEST(DiagramOf, AClientIsRightOfItsProvider) {
  const Diagram diagram = DiagramOf(Chain(1).catalogue());

  ASSERT_EQ(diagram.wires.size(), 2U);
  for (const auto& wire : diagram.wires) EXPECT_LT(wire.from_x, wire.to_x) << wire.title;
}

TEST(DiagramOf, OmitsStateTables) {
  const Diagram diagram = DiagramOf(Chain(1).catalogue());
  for (const DiagramNode& node : diagram.nodes) EXPECT_EQ(node.ports.size(), 2U) << node.path;
}

TEST(PrintSvg, EscapesXmlCharacters) {
  std::ostringstream out;
  PrintSvg(DiagramOf(Chain(2).catalogue()), out);

  EXPECT_TRUE(IsBalanced(out.str())) << out.str();
  EXPECT_THAT(out.str(), HasSubstr("Worker&lt;&amp;&gt;"));
  EXPECT_THAT(out.str(), HasSubstr("(failed): it is &quot;&lt;broken&gt;&quot;"));
}

TEST(PrintSvg, DrawsAnEmptySystem) {
  std::ostringstream out;
  PrintSvg(DiagramOf(tendon::Catalogue()), out);

  EXPECT_TRUE(IsBalanced(out.str()));
  EXPECT_THAT(out.str(), HasSubstr("0 processes, 0 components, 0 connections"));
}

using GraphTest = DemoFixture;

TEST_F(GraphTest, DrawsTheRunningSystem) {
  const Outcome drawn = Gcm({"graph", "--svg"});

  EXPECT_EQ(drawn.exit_code, program::kOk) << drawn.err;
  EXPECT_THAT(drawn.out, testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(IsBalanced(drawn.out));
  EXPECT_THAT(drawn.out, HasSubstr(">2 processes, 5 components, 1 connection</text>"));
  EXPECT_THAT(drawn.out, HasSubstr(">active · SimulatedArm</text>"));
  EXPECT_THAT(drawn.out,
              HasSubstr("<title>desk/supervisor/Robot -&gt; robot/arm/Control (active)</title>"));
  EXPECT_EQ(Gcm({"graph", "--text"}).out, Gcm({"graph"}).out);

  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));
  EXPECT_TRUE(EventuallySays({"graph", "--svg"}, "supervisor/Robot -&gt; robot/arm/Control (pend"));
  EXPECT_THAT(Gcm({"graph", "--svg"}).out, HasSubstr(">was active · SimulatedArm</text>"));
}

TEST_F(GraphTest, AcceptsOneFormatOnly) {
  for (const Program::Words& words : {Program::Words{"graph", "--svg", "--dot"},
                                      {"graph", "--svg", "--text"},
                                      {"graph", "--dot", "--text"}}) {
    const Outcome refused = Gcm(words);
    EXPECT_EQ(refused.exit_code, program::kUsage);
    EXPECT_THAT(refused.err, HasSubstr("gcm graph --help tells more"));
  }
}

}  // namespace
